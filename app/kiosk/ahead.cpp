// SPDX-License-Identifier: Apache-2.0
#include "kiosk/ahead.hpp"

#include <algorithm>

namespace quadrat::kiosk {
namespace {

// Of a map, what some candidate of these orders has the key of.
template <typename Map, typename KeyOf>
void keep_only(Map& map, const std::vector<Order>& orders, const KeyOf& key_of_candidate) {
    std::vector<typename Map::key_type> wanted;
    for (const Order& order : orders)
        for (const genome::Candidate& candidate : order.candidates)
            wanted.push_back(key_of_candidate(candidate, order.flight));
    std::erase_if(map, [&](const auto& entry) { return std::ranges::find(wanted, entry.first) == wanted.end(); });
}

template <typename Map>
typename Map::mapped_type found_in(const Map& map, const typename Map::key_type& key) {
    const auto found = map.find(key);
    return found == map.end() ? nullptr : found->second;
}

}  // namespace

void Ahead::want_layouts(Order wanted) {
    keep_only(layouts_, {wanted}, layout_key_of);
    wanted_ = std::move(wanted);
}

void Ahead::want_light(std::vector<Order> possible) {
    keep_only(lit_, possible, scene_key_of);
    possible_ = std::move(possible);
}

void Ahead::keep(const LayoutKey& key, std::shared_ptr<const synthesis::Layout> layout) {
    layouts_[key] = std::move(layout);
    if (wanted_) keep_only(layouts_, {*wanted_}, layout_key_of);
}

void Ahead::keep(const SceneKey& key, std::shared_ptr<const scene::Scene> lit) {
    lit_[key] = std::move(lit);
    keep_only(lit_, possible_, scene_key_of);
}

void Ahead::forget() { *this = {}; }

std::shared_ptr<const synthesis::Layout> Ahead::layout(const LayoutKey& key) const { return found_in(layouts_, key); }

std::shared_ptr<const scene::Scene> Ahead::lit(const SceneKey& key) const { return found_in(lit_, key); }

Scenes Ahead::lit() const {
    Scenes all;
    for (const auto& [key, scene] : lit_) all.push_back(scene);
    return all;
}

}  // namespace quadrat::kiosk
