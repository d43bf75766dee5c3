// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "genome/offer.hpp"
#include "nursery/plot.hpp"
#include "scene/scene.hpp"

namespace quadrat::nursery {

using Scenes = std::vector<std::shared_ptr<const scene::Scene>>;

// Scenes to be grown, the same way through each.
struct Order {
    std::vector<genome::Candidate> candidates;
    base::Seed flight;
};

// Of an order that has not been given yet.
struct HeadStart {
    Order coming;
    std::vector<genome::Aspect> known;  // are as in any order that can come
    std::vector<Order> possible;        // all that can come, if they are few; their flight is that of coming
};

// What is made before it is ordered, and what for. What no order that may come asks for is forgotten.
class Ahead {
  public:
    // Its keys are worked out once: what is still to be made is asked for every frame.
    struct Wanted {
        SceneKey key;
        genome::Candidate candidate;
        base::Seed flight;
        const LayoutKey& layout_key() const { return std::get<0>(key); }
    };

    void want_layouts(const Order& wanted);
    void want_light(const std::vector<Order>& possible);  // one of which will come
    void forget() { *this = {}; }

    const std::vector<Wanted>& to_lay_out() const { return to_lay_out_; }
    const std::vector<Wanted>& to_light() const { return to_light_; }  // each once

    void keep(const LayoutKey& key, std::shared_ptr<const synthesis::Layout> layout);
    void keep(const SceneKey& key, std::shared_ptr<const scene::Scene> lit);
    // Null where there is none.
    std::shared_ptr<const synthesis::Layout> layout(const LayoutKey& key) const;
    std::shared_ptr<const scene::Scene> lit(const SceneKey& key) const;  // in first light
    Scenes lit() const;                                                  // all of them

  private:
    void forget_unwanted();

    std::vector<Wanted> to_lay_out_;
    std::vector<Wanted> to_light_;
    std::map<LayoutKey, std::shared_ptr<const synthesis::Layout>> layouts_;
    std::map<SceneKey, std::shared_ptr<const scene::Scene>> lit_;
};

}  // namespace quadrat::nursery
