// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "genome/recipe.hpp"
#include "nursery/act.hpp"

namespace quadrat::nursery {

// What the last visitors bred, for Attract, the newest first. During a visit twice four landscapes need their room:
// then the newest alone stays, which costs nothing as the last finale, and the others are grown again when nobody
// waits.
class Gallery {
  public:
    static constexpr std::size_t kMost = 3;

    void hang(const Act& finale);  // whose first landscape is the newest now
    void make_room();              // all but the newest go
    // The newest of those that went; nothing when all are here.
    std::optional<genome::Recipe> missing() const;
    void bring_back(std::shared_ptr<const scene::Scene> scene);  // what missing() grows to
    // Where it hangs: the same in its own light.
    void replace(const std::shared_ptr<const scene::Scene>& old, const std::shared_ptr<const scene::Scene>& by);
    void open(base::Instant now) { act_.arrived = now; }

    // Of those that are here. Without recipes: they had their pictures taken as finales.
    const Act& act() const { return act_; }
    // What they are grown from.
    std::span<const genome::Recipe> recipes() const { return std::span(recipes_).first(act_.scenes.size()); }

  private:
    Act act_;
    std::vector<genome::Recipe> recipes_;  // of all; the first of them are here
};

}  // namespace quadrat::nursery
