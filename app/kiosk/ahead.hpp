// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "genome/offer.hpp"
#include "kiosk/plot.hpp"
#include "scene/scene.hpp"

namespace quadrat::kiosk {

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
    void want_layouts(Order wanted);
    void want_light(std::vector<Order> possible);  // one of which will come
    void forget();

    const std::optional<Order>& wanted() const { return wanted_; }
    const std::vector<Order>& possible() const { return possible_; }

    void keep(const LayoutKey& key, std::shared_ptr<const synthesis::Layout> layout);
    void keep(const SceneKey& key, std::shared_ptr<const scene::Scene> lit);
    // Null where there is none.
    std::shared_ptr<const synthesis::Layout> layout(const LayoutKey& key) const;
    std::shared_ptr<const scene::Scene> lit(const SceneKey& key) const;  // in first light
    Scenes lit() const;                                                  // all of them

  private:
    std::optional<Order> wanted_;
    std::map<LayoutKey, std::shared_ptr<const synthesis::Layout>> layouts_;
    std::vector<Order> possible_;
    std::map<SceneKey, std::shared_ptr<const scene::Scene>> lit_;
};

}  // namespace quadrat::kiosk
