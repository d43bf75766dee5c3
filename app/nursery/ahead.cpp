// SPDX-License-Identifier: Apache-2.0
#include "nursery/ahead.hpp"

#include <algorithm>
#include <utility>

namespace quadrat::nursery {
namespace {

std::vector<Ahead::Wanted> wanted_by(const std::vector<Order>& orders) {
    std::vector<Ahead::Wanted> all;
    for (const Order& order : orders) {
        for (const genome::Candidate& candidate : order.candidates) {
            SceneKey key = scene_key_of(candidate, order.flight);
            if (std::ranges::find(all, key, &Ahead::Wanted::key) == all.end())
                all.push_back({std::move(key), candidate, order.flight});
        }
    }
    return all;
}

template <typename Map>
typename Map::mapped_type found_in(const Map& map, const typename Map::key_type& key) {
    const auto found = map.find(key);
    return found == map.end() ? nullptr : found->second;
}

}  // namespace

void Ahead::want_layouts(const Order& wanted) {
    to_lay_out_ = wanted_by({wanted});
    forget_unwanted();
}

void Ahead::want_light(const std::vector<Order>& possible) {
    to_light_ = wanted_by(possible);
    forget_unwanted();
}

void Ahead::forget_unwanted() {
    std::erase_if(layouts_, [this](const auto& entry) {
        return std::ranges::find(to_lay_out_, entry.first, &Wanted::layout_key) == to_lay_out_.end();
    });
    std::erase_if(lit_, [this](const auto& entry) {
        return std::ranges::find(to_light_, entry.first, &Wanted::key) == to_light_.end();
    });
}

// What was worked on while it ceased to be wanted goes at once.
void Ahead::keep(const LayoutKey& key, std::shared_ptr<const synthesis::Layout> layout) {
    layouts_[key] = std::move(layout);
    forget_unwanted();
}

void Ahead::keep(const SceneKey& key, std::shared_ptr<const scene::Scene> lit) {
    lit_[key] = std::move(lit);
    forget_unwanted();
}

std::shared_ptr<const synthesis::Layout> Ahead::layout(const LayoutKey& key) const { return found_in(layouts_, key); }

std::shared_ptr<const scene::Scene> Ahead::lit(const SceneKey& key) const { return found_in(lit_, key); }

Scenes Ahead::lit() const {
    Scenes all;
    for (const auto& [key, scene] : lit_) all.push_back(scene);
    return all;
}

}  // namespace quadrat::nursery
