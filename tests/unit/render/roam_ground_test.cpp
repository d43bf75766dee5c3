// SPDX-License-Identifier: Apache-2.0
// The land drawn by ROAM instead of by blocks.
#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/held_ground.hpp"
#include "render/rehearsal.hpp"
#include "render/renderer.hpp"
#include "render/view.hpp"
#include "unit/render/gpu_fixture.hpp"
#include "unit/render/rugged_ground.hpp"

namespace quadrat::render {
namespace {

constexpr glm::ivec2 kSize{64, 64};

std::shared_ptr<const scene::Scene> rugged_scene() {
    auto scene = std::make_shared<scene::Scene>(rehearsal_scene());
    auto land = std::make_shared<scene::Land>(*scene->land);
    land->cell_m = tests::kCell_m;
    land->height_m = tests::rugged(0.3F, 3);
    for (float& height_m : land->height_m.samples) height_m += 12;
    land->kinds = mesh::Image(tests::kSide, tests::kSide, 2);
    for (std::size_t i = 0; i < land->kinds.bytes.size(); ++i)
        land->kinds.bytes[i] = static_cast<std::uint8_t>(13 * i / tests::kSide);
    mesh::Image patches(64, 64, 4);
    for (std::size_t i = 0; i < patches.bytes.size(); ++i)
        patches.bytes[i] = static_cast<std::uint8_t>(base::hash_of(base::Seed{3}, static_cast<int>(i), 0));
    land->albedo = scene::GroundColours(patches);
    land->fresh_water = {};  // lies in the cells of the ground that was there
    scene->land = land;
    // Dry: what is under water shows as water.
    mesh::Image& lit = scene->light.ground;
    for (std::size_t i = 3; i < lit.bytes.size(); i += 4) lit.bytes[i] = 0;
    return scene;
}

scene::Camera over_the_land(float turn) {
    return {{70 * std::sin(turn), 34, 70 * std::cos(turn)}, {20 * std::sin(turn + 2), 0, 20 * std::cos(turn + 2)}, 60};
}

choose::Allowance allowed(float alpha, std::size_t views = 1) {
    Detail detail;
    detail.alpha = alpha;
    return choose::allowance_of(detail, views);
}

class RoamGround : public Gpu {
  protected:
    struct Studio {
        explicit Studio(GroundBy ground) : renderer(ground) {
            const auto upload = renderer.begin_upload(rugged_scene());
            while (!upload->advance(std::size_t{1} << 22U)) continue;
            scene = upload->take();
        }
        Renderer renderer;
        std::shared_ptr<const GpuScene> scene;
    };
    static View view_of(const Studio& studio, const scene::Camera& camera, const Rect& place) {
        View view;
        view.scene = studio.scene;
        view.camera = camera;
        view.viewport = place;
        return view;
    }
    mesh::Image drawn(Studio& studio, const std::vector<View>& views, float alpha) const {
        Frame frame;
        frame.size = kSize;
        frame.framebuffer = canvas_.framebuffer;
        frame.detail.alpha = alpha;
        frame.measured = {false, false, true, false, false};
        frame.views = views;
        studio.renderer.draw(frame);
        return studio.renderer.read_pixels(frame);
    }
    mesh::Image drawn(Studio& studio, float turn, float alpha) const {
        return drawn(studio, {view_of(studio, over_the_land(turn), {0, 0, kSize.x, kSize.y})}, alpha);
    }
};

// Of all channels of all pixels, 0 to 255.
double difference(const mesh::Image& a, const mesh::Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.bytes.size(); ++i) sum += std::abs(int{a.bytes[i]} - int{b.bytes[i]});
    return sum / static_cast<double>(a.bytes.size());
}

std::vector<std::uint32_t> indices_of(const HeldGround& held, const choose::IndexRange& range) {
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, held.indices().name());
    const auto bytes = [](std::size_t count) { return static_cast<GLsizeiptr>(count * sizeof(std::uint32_t)); };
    const auto* mapped = static_cast<const std::uint32_t*>(
        glMapBufferRange(GL_ELEMENT_ARRAY_BUFFER, bytes(range.first), bytes(range.count), GL_MAP_READ_BIT));
    std::vector<std::uint32_t> indices(mapped, mapped + range.count);
    glUnmapBuffer(GL_ELEMENT_ARRAY_BUFFER);
    return indices;
}

TEST_F(RoamGround, IsMadeWhereItIsAskedFor) {
    const Studio by_roam(GroundBy::Roam);
    EXPECT_NE(by_roam.scene->country->land.land.roam, nullptr);
    EXPECT_EQ(by_roam.scene->country->land.surround.roam, nullptr);
    const Studio by_blocks(GroundBy::Blocks);
    EXPECT_EQ(by_blocks.scene->country->land.land.roam, nullptr);
}

TEST_F(RoamGround, LooksAsByBlocksWhereBothAreFine) {
    Studio by_roam(GroundBy::Roam);
    Studio by_blocks(GroundBy::Blocks);
    for (const float turn : {0.0F, 1.3F, 2.9F, 4.4F}) {
        const mesh::Image fine = drawn(by_blocks, turn, 100);
        EXPECT_LT(difference(drawn(by_roam, turn, 100), fine), 1) << turn;
        EXPECT_GT(difference(drawn(by_roam, turn + 0.05F, 100), fine), 3) << "of another view, " << turn;
        EXPECT_NE(drawn(by_roam, turn, 0.3F), drawn(by_blocks, turn, 0.3F)) << "other triangles, " << turn;
    }
}

// What was drawn before, and what is drawn beside it, of the same land: it makes no difference.
TEST_F(RoamGround, IsTheSameWhereverTheEyeWas) {
    Studio studio(GroundBy::Roam);
    const Rect low{0, 0, kSize.x, kSize.y / 2};
    const Rect high{0, kSize.y / 2, kSize.x, kSize.y / 2};
    const View one = view_of(studio, over_the_land(0.4F), low);
    const View other = view_of(studio, over_the_land(3.6F), high);
    const mesh::Image both = drawn(studio, {one, other}, 1);
    EXPECT_EQ(drawn(studio, {one, other}, 1), both);
    const auto drawn_alone = [&](View view) {
        Studio fresh(GroundBy::Roam);
        view.scene = fresh.scene;
        return drawn(fresh, {view}, 1);
    };
    const mesh::Image first = drawn_alone(one);
    const mesh::Image second = drawn_alone(other);
    for (int row = 0; row < kSize.y; ++row)
        for (int x = 0; x < kSize.x; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(both.pixel(x, row)[c], (row < kSize.y / 2 ? second : first).pixel(x, row)[c])
                    << x << ", " << row;
}

TEST_F(RoamGround, NothingMorphsAndWhatIsNearComesFirst) {
    const Studio studio(GroundBy::Roam);
    const mesh::Field field = rugged_scene()->land->height_m;
    const View view = view_of(studio, over_the_land(0.4F), {0, 0, kSize.x, kSize.y});
    HeldGround held;
    for (const float alpha : {0.2F, 1.0F, 4.0F}) {
        held.update(view, clip_from_world_of(view), {allowed(alpha), 300, 1});
        const choose::IndexRange& land = held.land();
        EXPECT_EQ(land.ease, 0) << "less than any distance and error make begin";
        ASSERT_GT(land.near_count, 0U);
        ASSERT_LT(land.near_count, land.count);
        const auto indices = indices_of(held, land);
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            glm::vec3 low{1e9F};
            glm::vec3 high{-1e9F};
            for (std::size_t k = 0; k < 3; ++k) {
                const tests::Corner at = tests::corner(indices[i + k]);
                const glm::vec3 place{(static_cast<float>(at.column) - 64) * tests::kCell_m,
                                      field.at(at.column, at.row), (static_cast<float>(at.row) - 64) * tests::kCell_m};
                low = glm::min(low, place);
                high = glm::max(high, place);
            }
            const glm::vec3 eye_m = view.camera.eye_m;
            const bool is_near = glm::distance(eye_m, glm::clamp(eye_m, low, high)) < held.grain_m();
            ASSERT_EQ(is_near, i < land.near_count) << alpha << ", triangle " << i / 3;
        }
    }
}

TEST_F(RoamGround, KeepsToItsShareOfTheFramesTriangles) {
    const Studio studio(GroundBy::Roam);
    const View view = view_of(studio, over_the_land(0.4F), {0, 0, kSize.x, kSize.y});
    HeldGround held;
    held.update(view, clip_from_world_of(view), {allowed(1), 5000, 1});
    const std::size_t whole = held.land().count / 3;
    held.update(view, clip_from_world_of(view), {allowed(1, 16), 5000, 1});
    EXPECT_LE(held.land().count / 3, 24'000U / 16);
    EXPECT_GT(whole, 2 * held.land().count / 3);
}

// A right triangle and its halves, which lie at 45 degrees to it: each has one level, and none is lost.
TEST_F(RoamGround, SortsAllTrianglesByLevelForWires) {
    const Studio studio(GroundBy::Roam);
    const View view = view_of(studio, over_the_land(0.4F), {0, 0, kSize.x, kSize.y});
    HeldGround held;
    held.update(view, clip_from_world_of(view), {allowed(0.3F), 700, 1});
    held.sort_by_level(*studio.scene);
    std::size_t sorted = 0;
    std::size_t coarser = 0;
    for (const choose::IndexRange& level : held.land_by_level()) {
        EXPECT_EQ(level.first, sorted);
        EXPECT_GE(level.level, coarser);
        EXPECT_EQ(level.ease, 0);
        sorted += level.count;
        coarser = level.level;
    }
    EXPECT_EQ(sorted, held.land().count);
    EXPECT_GE(held.land_by_level().size(), 3U);
}

}  // namespace
}  // namespace quadrat::render
