// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "render/rehearsal.hpp"
#include "render/renderer.hpp"
#include "render/view.hpp"
#include "unit/render/gpu_fixture.hpp"

namespace quadrat::render {
namespace {

constexpr glm::ivec2 kSize{64, 64};
constexpr float kShore_m = 60;

// A sea whose mirror was held up in the middle: darkest at the horizon, brighter and brighter upward.
std::shared_ptr<const scene::Scene> sea() {
    auto scene = std::make_shared<scene::Scene>(rehearsal_scene());
    auto land = std::make_shared<scene::Land>(*scene->land);
    land->height_m.samples.assign(land->height_m.samples.size(), -8.0F);
    land->fresh_water = {};
    scene->land = land;
    scene->mirror.light = mesh::Image(8, 32, 4);
    for (int row = 0; row < 32; ++row)
        for (int i = 0; i < 8 * 4; ++i)
            scene->mirror.light.bytes[static_cast<std::size_t>(row * 8 * 4 + i)] = static_cast<std::uint8_t>(7 * row);
    scene->mirror.shore_m.fill(kShore_m);
    return scene;
}

class MirrorOnWater : public Gpu {
  protected:
    void SetUp() override {
        Gpu::SetUp();
        renderer_.emplace();
        const auto upload = renderer_->begin_upload(sea());
        while (!upload->advance(std::size_t{1} << 22U)) continue;
        scene_ = upload->take();
    }
    void TearDown() override {
        scene_.reset();
        renderer_.reset();
        Gpu::TearDown();
    }
    mesh::Image drawn(const scene::Camera& camera, float seconds = 0) {
        View view;
        view.scene = scene_;
        view.camera = camera;
        view.viewport = {0, 0, kSize.x, kSize.y};
        Frame frame;
        frame.size = kSize;
        frame.framebuffer = canvas_.framebuffer;
        frame.measured = {false, false, false, true, false};
        frame.views = {view};
        frame.seconds = seconds;
        renderer_->draw(frame);
        return renderer_->read_pixels(frame);
    }

  private:
    std::optional<Renderer> renderer_;
    decltype(View::scene) scene_;
};

// Adds the brightness of each row of pixels on average, from the nearest water to the farthest.
void add_rows(std::vector<float>& rows, const mesh::Image& picture, float share) {
    rows.resize(static_cast<std::size_t>(picture.height));
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (int x = 0; x < picture.width; ++x)
            rows[i] += share / static_cast<float>(picture.width) *
                       static_cast<float>(picture.pixel(x, picture.height - 1 - static_cast<int>(i))[1]);
}

TEST_F(MirrorOnWater, ShowsNoEdgeWhereTheShoreOfItsPictureIs) {
    // Over so long, no gust is left in the mean.
    constexpr int kTimes = 64;
    std::vector<float> rows;
    for (int i = 0; i < kTimes; ++i)
        add_rows(rows, drawn({{0, 30, 100}, {0, 0, -40}, 30}, 37.0F * static_cast<float>(i)), 1.0F / kTimes);
    // Toward the shore what it mirrors is lower and lower, and beyond it no higher again.
    constexpr float kLeft = 0.5F;
    const auto brightest = std::max_element(rows.begin() + 8, rows.begin() + 40);
    ASSERT_GT(*brightest, 130);
    for (auto row = brightest + 1; row < brightest + 20; ++row)
        EXPECT_LT(*row, *(row - 1) + kLeft) << row - rows.begin();
    EXPECT_LT(*(brightest + 20), 0.85F * *brightest);
}

// Ripples are finer than a pixel there: without gusts a lake would be a flat plate.
TEST_F(MirrorOnWater, GustsAreSeenFromAfar) {
    const mesh::Image picture = drawn({{0, 60, 700}, {0, 0, 100}, 30});
    int flat = 0;
    int rows = 0;
    for (int row = picture.height / 2; row < picture.height; ++row, ++rows) {
        int least = 255;
        int most = 0;
        for (int x = 0; x < picture.width; ++x) {
            least = std::min<int>(least, picture.pixel(x, row)[1]);
            most = std::max<int>(most, picture.pixel(x, row)[1]);
        }
        flat += most - least < 8;
    }
    EXPECT_LT(flat, rows / 10);
}

}  // namespace
}  // namespace quadrat::render
