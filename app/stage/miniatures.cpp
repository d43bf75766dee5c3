// SPDX-License-Identifier: Apache-2.0
#include "stage/miniatures.hpp"

#include <chrono>
#include <utility>

namespace quadrat::stage {
namespace {

// What has just come is brought to the GPU and refined in these frames: they have no time to spare.
constexpr std::chrono::milliseconds kSettled{600};

}  // namespace

std::optional<Miniatures::Due> Miniatures::due(const exhibit::State& state, exhibit::Instant shown_for) {
    using exhibit::Screen;
    if (state.family.empty()) kept_.clear();
    if (state.family.empty() || shown_for < kSettled) return std::nullopt;
    const bool is_of_four = state.family[static_cast<std::size_t>(state.here)].was_seen;
    const bool is_on_show =
        is_of_four ? state.screen == Screen::Ask : state.screen == Screen::Finale || state.screen == Screen::Family;
    const Miniature* kept = find(state.here);
    if (!is_on_show || (kept != nullptr && kept->is_of_four == is_of_four)) return std::nullopt;
    return Due{state.here, is_of_four};
}

void Miniatures::keep(const Due& due, mesh::Image picture) {
    kept_[due.node] = {std::move(picture), due.is_of_four, ++number_};
}

const Miniatures::Miniature* Miniatures::find(int node) const {
    const auto found = kept_.find(node);
    return found == kept_.end() ? nullptr : &found->second;
}

}  // namespace quadrat::stage
