// SPDX-License-Identifier: Apache-2.0
// Any polygon is roofed so that faces cover it and lie in their planes, or is refused with a reason.
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "support/plans.hpp"

namespace mesh = quadrat::mesh;

// A byte of how, then the plan.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 13 || size > 600) return 0;
    mesh::RoofOptions options;
    options.profiles = {{{{0, 45}}}, {{{0, 90}, {2, 30}}}, {{{0, 60}}}, {{{0, 20}, {1, 70}}}};
    const std::uint8_t how = data[0];
    const mesh::Plan plan = quadrat::tests::plan_of_bytes(data + 1, size - 1, (how & 1) != 0 ? 1.0 / 256 : 0.37);
    for (std::size_t i = 0; i < plan.edge_count(); ++i)
        options.profile_of_edge.push_back((how & 2) != 0 ? static_cast<int>((i * 7 + how) % 4) : 0);
    if ((how & 4) != 0) options.height_m = 3;
    if ((how & 8) != 0) options.ambiguity = mesh::Ambiguity::MostVolume;
    try {
        const mesh::Roof roof = mesh::straight_skeleton(plan, options);
        if (!quadrat::tests::fault_of(plan, options, roof).empty()) std::abort();
    } catch (const mesh::PlanError& error) {
        if (std::strlen(error.what()) == 0) std::abort();
    }
    return 0;
}
