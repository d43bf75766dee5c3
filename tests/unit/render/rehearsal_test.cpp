// SPDX-License-Identifier: Apache-2.0
#include "render/rehearsal.hpp"

#include "render/gl/limits.hpp"
#include "render/renderer.hpp"
#include "unit/render/gpu_fixture.hpp"

namespace quadrat::render {
namespace {

class Rehearsal : public Gpu {
  protected:
    Frame frame_of(glm::ivec2 size) const {
        Frame frame;
        frame.size = size;
        frame.framebuffer = canvas_.framebuffer;
        return frame;
    }
};

TEST_F(Rehearsal, DrawsSomethingOfEveryKind) {
    for (const GroundBy ground : {GroundBy::Blocks, GroundBy::Roam}) {
        Renderer renderer(ground);
        const Drawn drawn = renderer.rehearse(frame_of({1280, 720}));
        const auto of = [&](DrawnKind kind) { return drawn.of[static_cast<std::size_t>(kind)]; };
        for (std::size_t kind = 0; kind < kDrawnKinds; ++kind) EXPECT_GT(drawn.of[kind].triangles, 0U) << kind;
        EXPECT_GE(of(DrawnKind::Leaves).draws, 3U) << "with their picture, plain, and as masses";
        EXPECT_GE(of(DrawnKind::Ground).draws, 5U) << "houses, stone, near, far, around";
        EXPECT_GE(of(DrawnKind::Water).draws, 2U) << "sea and river";
        EXPECT_GE(of(DrawnKind::Sky).draws, 4U) << "dome and clouds, stars, disc, rainbow";
    }
    EXPECT_EQ(gl::limits::breaches(), std::vector<std::string>{});
}

TEST_F(Rehearsal, LeavesNothingBehind) {
    Renderer renderer;
    const Frame frame = frame_of({64, 64});
    const Drawn before = renderer.draw(frame);
    const mesh::Image empty = renderer.read_pixels(frame);
    renderer.rehearse(frame);
    const Drawn after = renderer.draw(frame);
    EXPECT_EQ(renderer.read_pixels(frame), empty);
    EXPECT_LE(after.objects, before.objects + 4) << "views drawn smaller keep what they are drawn to";
}

}  // namespace
}  // namespace quadrat::render
