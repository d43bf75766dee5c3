// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/most_seen.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrat::synthesis {

void keep_most_seen(const Sight& sight, std::vector<Candidate>& plants, std::size_t most) {
    if (plants.size() <= most) return;
    std::vector<std::pair<float, std::size_t>> order;
    order.reserve(plants.size());
    for (std::size_t i = 0; i < plants.size(); ++i) {
        const View view = sight.view_of(plants[i].at_m);
        const bool is_seen = view.along_m > 0 && view.aside < 1.0F;
        const float far = view.to_way_m / 260.0F;
        const float chance = plants[i].mark - std::floor(plants[i].mark);
        order.emplace_back(chance * (1.0F + far * far) + (is_seen ? 0.0F : 0.8F + 0.01F * view.to_way_m), i);
    }
    std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most), order.end());
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < most; ++i) kept.push_back(order[i].second);
    std::sort(kept.begin(), kept.end());
    std::vector<Candidate> fewer;
    fewer.reserve(most);
    for (const std::size_t i : kept) fewer.push_back(plants[i]);
    plants = std::move(fewer);
}

}  // namespace quadrat::synthesis
