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
#include "nursery/collection.hpp"

namespace quadrat::nursery {

// What staff chose of what visitors bred.
struct Chosen {
    std::vector<genome::Recipe> favourites;  // hang in turn, whoever bred since
    std::vector<std::string> hidden;         // by their codes (genome/scene_code.hpp): never hang
    bool shows_year = false;                 // the first that hangs comes in its other seasons too, one after the other
    friend bool operator==(const Chosen&, const Chosen&) = default;
};

// What is known of a finale besides what it grows from.
struct Birth {
    std::optional<genome::Description> words = {};
    std::int64_t day = 0;     // since 1970
    std::string parent = {};  // the code of the landscape that its visitor bred on from; "": none
};

// What hangs in Attract: the newest that visitors bred, then what staff chose, then the worthiest of the collection. No
// two are alike, as far as their words are known. Last, where it is wished, the rest of the first one's year: its own
// season comes next.
// During a visit twice four landscapes need their room: then the newest alone stays, which costs nothing as the last
// finale, and the others are grown again when nobody waits.
class Gallery {
  public:
    static constexpr std::size_t kMost = 3;                               // hang at once, besides seasons
    static constexpr base::Instant kShownFor = std::chrono::seconds{24};  // then the next of them

    void hang(const Act& finale, const Birth& birth = {});  // whose first landscape is the newest now
    void choose(Chosen chosen);
    void make_room();  // all but the newest go; the next favourites come
    void turn();       // the first of the favourites goes, the next one comes
    // The first of those that are not here; nothing when all are.
    std::optional<genome::Recipe> missing() const;
    // What a recipe grew to. It does not hang where it is not the one that is missing: others were chosen meanwhile.
    void bring_back(const genome::Recipe& recipe, std::shared_ptr<const scene::Scene> scene);
    // Where it hangs: the same in full light.
    void replace(const std::shared_ptr<const scene::Scene>& old, const std::shared_ptr<const scene::Scene>& by);
    void open(base::Instant now);  // Attract begins
    // Somebody has come, or, as with all that hang on a wall, they are to change: each of them was shown so long. To
    // whoever came: they breed on from what is shown, or not.
    enum class Came { Nobody, Somebody, ToBreedOn };
    void leave(base::Instant now, Came who);
    // The one that is shown now, of those that are here; nothing where none is.
    std::optional<std::size_t> shown(base::Instant now) const;

    std::string code_shown(base::Instant now) const;  // its code; "": none

    const Collection& collection() const { return collection_; }
    void recall(Collection collection);  // of the runs before

    // Of those that are here. Without recipes: they had their pictures taken as finales.
    const Act& act() const { return act_; }
    // What they are grown from.
    std::span<const genome::Recipe> recipes() const { return here_; }

  private:
    bool is_hidden(const genome::Recipe& recipe) const;
    const Work* newest() const;  // null: nobody has bred anything
    void plan();
    void hang_what_is_here();

    Act act_;
    std::vector<genome::Recipe> here_;  // of the act's landscapes
    std::vector<genome::Recipe> wall_;  // all that should hang, in their order
    Collection collection_;
    std::optional<Work> newest_;  // of this run
    Chosen chosen_;
    std::size_t turn_ = 0;  // the favourite that comes first
};

}  // namespace quadrat::nursery
