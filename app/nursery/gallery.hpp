// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "genome/recipe.hpp"
#include "nursery/act.hpp"

namespace quadrat::nursery {

// What staff chose of what visitors bred.
struct Chosen {
    std::vector<genome::Recipe> favourites;  // hang in turn, whoever bred since
    std::vector<std::string> hidden;         // by their codes (genome/scene_code.hpp): never hang
    friend bool operator==(const Chosen&, const Chosen&) = default;
};

// What hangs in Attract: the newest that visitors bred, then what staff chose, then what was bred before. During a
// visit twice four landscapes need their room: then the newest alone stays, which costs nothing as the last finale, and
// the others are grown again when nobody waits.
class Gallery {
  public:
    static constexpr std::size_t kMost = 3;        // hang at once
    static constexpr std::size_t kRemembered = 9;  // that were bred, for when others are hidden

    void hang(const Act& finale);  // whose first landscape is the newest now
    void choose(Chosen chosen);
    void make_room();  // all but the newest go; the next favourites come
    // The first of those that are not here; nothing when all are.
    std::optional<genome::Recipe> missing() const;
    // What a recipe grew to. It does not hang where it is not the one that is missing: others were chosen meanwhile.
    void bring_back(const genome::Recipe& recipe, std::shared_ptr<const scene::Scene> scene);
    // Where it hangs: the same in its own light.
    void replace(const std::shared_ptr<const scene::Scene>& old, const std::shared_ptr<const scene::Scene>& by);
    void open(base::Instant now) { act_.arrived = now; }

    // Of those that are here. Without recipes: they had their pictures taken as finales.
    const Act& act() const { return act_; }
    // What they are grown from.
    std::span<const genome::Recipe> recipes() const { return here_; }

  private:
    std::optional<genome::Recipe> newest() const;
    void plan();
    void hang_what_is_here();

    Act act_;
    std::vector<genome::Recipe> here_;  // of the act's landscapes
    std::vector<genome::Recipe> wall_;  // all that should hang, in their order
    std::vector<genome::Recipe> bred_;  // newest first
    Chosen chosen_;
    std::size_t turn_ = 0;  // the favourite that comes first
};

}  // namespace quadrat::nursery
