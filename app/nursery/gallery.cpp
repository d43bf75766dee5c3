// SPDX-License-Identifier: Apache-2.0
#include "nursery/gallery.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace quadrat::nursery {

void Gallery::hang(const Act& finale) {
    assert(!finale.scenes.empty() && finale.scenes.size() == finale.recipes.size());
    act_.scenes.insert(act_.scenes.begin(), finale.scenes.front());
    recipes_.insert(recipes_.begin(), finale.recipes.front());
    act_.scenes.resize(std::min(act_.scenes.size(), kMost));
    recipes_.resize(std::min(recipes_.size(), kMost));
    act_.number = finale.number;
}

void Gallery::make_room() { act_.scenes.resize(std::min<std::size_t>(act_.scenes.size(), 1)); }

std::optional<genome::Recipe> Gallery::missing() const {
    if (act_.scenes.size() == recipes_.size()) return std::nullopt;
    return recipes_[act_.scenes.size()];
}

void Gallery::bring_back(std::shared_ptr<const scene::Scene> scene) {
    assert(missing());
    act_.scenes.push_back(std::move(scene));
}

void Gallery::replace(const std::shared_ptr<const scene::Scene>& old, const std::shared_ptr<const scene::Scene>& by) {
    std::ranges::replace(act_.scenes, old, by);
}

}  // namespace quadrat::nursery
