// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <optional>
#include <vector>

#include "render/choose/allowance.hpp"
#include "render/choose/crowd.hpp"
#include "render/choose/frustum.hpp"
#include "render/choose/view_block.hpp"
#include "render/held_ground.hpp"
#include "render/passes/cover.hpp"
#include "render/passes/distance.hpp"
#include "render/renderer.hpp"

// What is drawn of each view, before any of it is.
namespace quadrat::render {

float scale_of(const Frame& frame);
bool draws_plants(const Frame& frame);

// One view's share of the frame.
struct Selection {
    Selection(const glm::mat4& clip_from_world, const choose::Allowance& allowed)
        : frustum(clip_from_world), allowance(allowed) {}

    choose::Frustum frustum;
    choose::Allowance allowance;
    choose::Reach reach;
    glm::vec2 strip{-1, 1};  // of the view, clip x
    choose::ViewBlock block;
    choose::Gathering gathering;
    choose::Sight plants;
    std::size_t other_triangles = 0;  // than those of plants
    std::vector<choose::Batch> batches;
    choose::CoverWish cover_wish;
    choose::CoverSeen cover;
    std::optional<glm::mat3> held_sky_from_view;        // where the sky is a picture of some frames ago
    std::optional<passes::DistanceWarp> held_distance;  // where all is that the reach leaves out
};

Selection outline(const Frame& frame, std::size_t slot);
// What of its ground is drawn how closely, and which plants are seen.
void look(const Frame& frame, const View& view, HeldGround& held, Selection& selection);
// What the views show as it was held.
struct HeldTriangles {
    std::vector<choose::Crowding> plants;
    std::size_t others = 0;
};
// All views' plants are drawn with one fineness: a forest has more of the frame's triangles than a desert. before: of
// the frame before.
int affordable_step(const Frame& frame, const std::vector<Selection>& selections, HeldTriangles held,
                    std::optional<int> before);

}  // namespace quadrat::render
