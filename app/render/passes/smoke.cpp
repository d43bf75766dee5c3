// SPDX-License-Identifier: Apache-2.0
#include "render/passes/smoke.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "base/seed.hpp"
#include "render/gl/buffer_upload.hpp"

namespace quadrat::render::passes {
namespace {

constexpr std::size_t kPuffs = 22;         // of a chimney
constexpr std::size_t kMostChimneys = 24;  // that smoke: the first ones built
constexpr float kStrongest_m_s = 1.1F;     // of the wind among houses
constexpr float kAmongHouses = 0.13F;      // of the wind that drives the clouds
constexpr float kOpacity = 0.22F;
constexpr std::array<glm::vec2, 4> kCorners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

struct PuffCorner {
    glm::vec3 chimney_m;
    glm::vec4 corner_age;
    glm::vec3 strength_width_rise;
};

struct Smoking {
    glm::vec3 chimney_m;
    scene::Plume plume;
};

std::vector<Smoking> chimneys_of(const scene::Settlement& settlement) {
    std::vector<Smoking> all;
    for (const scene::House& house : settlement.houses) {
        const scene::Building& building = settlement.buildings[house.building];
        const std::vector<glm::vec3>& chimneys = building.chimneys_m;
        if (house.plume.strength <= 0 || chimneys.empty() || all.size() == kMostChimneys) continue;
        const auto which = static_cast<std::size_t>(house.plume.chimney * static_cast<float>(chimneys.size()));
        all.push_back({scene::placed(house, chimneys[std::min(which, chimneys.size() - 1)]), house.plume});
    }
    return all;
}

}  // namespace

void add_smoke(gl::Slices& slices, SmokeOnGpu& smoke, const std::shared_ptr<const scene::Land>& land) {
    const auto chimneys = std::make_shared<std::vector<Smoking>>(chimneys_of(land->settlement));
    smoke.puffs = chimneys->size() * kPuffs;
    if (smoke.puffs == 0) return;
    gl::add_made<PuffCorner>(slices, smoke.corners, GL_ARRAY_BUFFER, 4 * smoke.puffs, [chimneys](std::size_t i) {
        const std::size_t puff = i / 4;
        const std::size_t chimney = puff / kPuffs;
        const float chance = base::unit_of(base::hash_of(base::Seed{7}, static_cast<std::int64_t>(puff), 0));
        const auto& [chimney_m, plume] = (*chimneys)[chimney];
        const float age = plume.phase + (static_cast<float>(puff % kPuffs) + 0.6F * chance) / kPuffs;
        return PuffCorner{
            chimney_m, {kCorners[i % 4], age - std::floor(age), chance}, {plume.strength, plume.width, plume.rise}};
    });
    gl::add_made<std::uint16_t>(slices, smoke.indices, GL_ELEMENT_ARRAY_BUFFER, 6 * smoke.puffs, [](std::size_t i) {
        constexpr std::array<std::size_t, 6> kOfQuad{0, 1, 2, 0, 2, 3};
        return static_cast<std::uint16_t>(4 * (i / 6) + kOfQuad[i % 6]);
    });
}

SmokePass::SmokePass()
    : program_("smoke.vert", "smoke.frag"),
      vertices_{{0,
                 sizeof(PuffCorner),
                 gl::Advance::PerVertex,
                 {{0, 3, GL_FLOAT, gl::Numbers::AsTheyAre, 0},
                  {1, 4, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(PuffCorner, corner_age)},
                  {2, 3, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(PuffCorner, strength_width_rise)}}}} {}

gl::Work SmokePass::draw(const SmokeOnGpu& smoke, glm::vec2 wind_m_s, float growth, const choose::Reach& reach) const {
    const auto chimneys = static_cast<std::size_t>(growth * static_cast<float>(smoke.puffs / kPuffs));
    const std::size_t puffs = kPuffs * chimneys;
    if (puffs == 0) return {};
    program_.use();
    const float strong = kAmongHouses * glm::length(wind_m_s);
    const glm::vec2 wind = kAmongHouses * wind_m_s * std::min(1.0F, kStrongest_m_s / std::max(strong, 0.01F));
    glUniform4f(0, wind.x, wind.y, kOpacity, 0);
    const float part = reach.part == choose::Reach::Part::Whole  ? 0.0F
                       : reach.part == choose::Reach::Part::Near ? 1.0F
                                                                 : -1.0F;
    glUniform4f(1, reach.about_m.x, reach.about_m.y, reach.split_m, part);
    vertices_.bind();
    vertices_.feed(0, smoke.corners.name());
    vertices_.feed_indices(smoke.indices.name());
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    glDisable(GL_CULL_FACE);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(6 * puffs), GL_UNSIGNED_SHORT, nullptr);
    glEnable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    return {1, 2 * puffs, 4 * puffs};
}

}  // namespace quadrat::render::passes
