// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "genome/scene_code.hpp"
#include "genome/words.hpp"

namespace quadrat::nursery {

// A landscape that visitors bred, and how it has fared since among those who passed it. Nothing of the visitors.
struct Work {
    std::string code;  // genome/scene_code.hpp; what it grows from
    genome::Recipe recipe;
    std::optional<genome::Description> words;
    std::int64_t day = 0;  // it was bred on, since 1970
    std::string parent;    // the code of the one that it was bred on from; "": none
    int generation = 1;    // 1 + its parent's
    double shown_s = 0;    // in Attract
    double stays = 0;      // visits that began while it was shown there
    double chosen = 0;     // of those, that bred on from it
    friend bool operator==(const Work&, const Work&) = default;
};

// How many it stops a minute, with a newcomer's benefit of the doubt: half a minute in which one stopped. Nobody sees
// who walks past: a passer-by stays by beginning a visit, and who breeds on from a work counts three times.
double worth(const Work& work);

// Whether two look much the same: in words, where both have them; else by their codes.
bool are_alike(const Work& a, const Work& b);

// The works that compete for a place in Attract.
class Collection {
  public:
    static constexpr std::size_t kMost = 24;

    // It becomes the newest. Of two that are alike the worthier stays, the newer where neither is; of too many the
    // least worthy goes, but never the newest.
    void admit(Work work);
    const std::vector<Work>& works() const { return works_; }
    const Work* find(std::string_view code) const;  // null: it is not among them
    std::vector<genome::Recipe> ranked() const;     // the worthiest first

    // What happened to one; of no effect for one that is not among them.
    void was_shown(std::string_view code, double seconds);
    void was_stopped_at(std::string_view code, bool was_chosen);

    // As it is kept on disk. What cannot be read, of this program or another, is left out.
    std::string to_json() const;
    static Collection from_json(std::string_view json);

    friend bool operator==(const Collection&, const Collection&) = default;

  private:
    Work* find_to_change(std::string_view code);
    std::vector<Work> works_;  // newest first
};

}  // namespace quadrat::nursery
