// SPDX-License-Identifier: Apache-2.0
#include "benches/passes.hpp"

#include <glm/geometric.hpp>

#include "benches/benches.hpp"
#include "benches/yardstick.hpp"

namespace quadrat::benches {
namespace {

// One view over the whole picture, of nothing but one part; the camera sees nothing else.
render::Frame pass_of(render::Frame picture, const render::Measured& what, float look_up) {
    picture.signs.clear();
    picture.views.resize(1);
    render::View& view = picture.views.front();
    view.viewport = {0, 0, picture.size.x, picture.size.y};
    const glm::vec3 ahead = view.camera.target_m - view.camera.eye_m;
    view.camera.target_m =
        view.camera.eye_m + glm::normalize(glm::vec3{ahead.x, 0, ahead.z}) + glm::vec3{0, look_up, 0};
    picture.measured = what;
    return picture;
}

template <typename Plain>
PassTurns in_turns(stage::Easel& easel, render::Frame pass, const Plain& plain, int turns) {
    constexpr int kFrames = 8;  // in which all that is drawn only every few frames is drawn as often as it ever is
    const auto frame_ms = [&](const auto& draw) {
        const auto frames = [&] {
            for (int n = 0; n < kFrames; ++n) {
                draw(easel.display().begin_frame());
                easel.renderer().finish();
                easel.display().present();
            }
        };
        return milliseconds_of(frames) / kFrames;
    };
    PassTurns taken;
    for (int turn = 0; turn < turns; ++turn) {
        taken.ours_ms.push_back(frame_ms([&](const display::Canvas& canvas) {
            pass.framebuffer = canvas.framebuffer;
            taken.triangles = easel.renderer().draw(pass).triangles;
        }));
        taken.plain_ms.push_back(frame_ms([&](const display::Canvas& canvas) { plain.draw(canvas); }));
    }
    return taken;
}

}  // namespace

PassTurns land_pass(stage::Easel& easel, const render::Frame& picture, int squares_a_side, int turns) {
    render::Frame above = picture;
    above.views.front().camera.eye_m.y += 40;
    return in_turns(easel, pass_of(above, {false, false, true, false, false}, -0.7F), PlainGround{squares_a_side},
                    turns);
}

PassTurns sky_pass(stage::Easel& easel, const render::Frame& picture, int turns) {
    return in_turns(easel, pass_of(picture, {false, false, false, false, true}, 0.6F), PlainSky{}, turns);
}

double ratio_of(const PassTurns& turns) {
    std::vector<double> ratios;
    for (std::size_t turn = 0; turn < turns.ours_ms.size(); ++turn)
        ratios.push_back(turns.ours_ms[turn] / turns.plain_ms[turn]);
    return machine::percentile(ratios, 0.5);
}

}  // namespace quadrat::benches
