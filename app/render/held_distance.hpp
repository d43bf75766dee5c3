// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "render/gl/buffer.hpp"
#include "render/gl/deep_target.hpp"
#include "render/gl/multisampled_target.hpp"
#include "render/gl/texture_target.hpp"
#include "render/passes/distance.hpp"
#include "render/renderer.hpp"
#include "render/selection.hpp"
#include "render/view_painter.hpp"

namespace quadrat::render {

// What is far of one view, as a picture that serves some frames: a little wider than the view, drawn from where the eye
// will be in the middle of its time. What is nearer than its split is drawn over it each frame. It is shown as a sphere
// of twice the split's radius about where it was drawn from, so that nothing of it, from the split to infinity, lies
// farther from its place than parallax over half the split's distance: image caching after Shade et al. 1996 and
// Schaufler & Stuerzlinger 1996, with a distance for a border instead of a hierarchy.
class HeldDistance {
  public:
    static constexpr float kMost_px = 0.7F;  // that anything held may lie from its place

    // What a picture is of.
    struct Sight {
        std::weak_ptr<const GpuScene> scene;
        Rect viewport;  // of the view
        float fov_deg = 0;
        glm::vec3 eye_m{0};
        glm::mat3 picture_from_way{1};  // from a way in the world to the picture's coordinates, times depth
        float split_m = 1;
        float seconds = 0;
        float light = 1;
        // As its plants were chosen, of its strips one after the other.
        std::vector<choose::Gathering> gatherings;
        std::vector<choose::Sight> plants;
        std::size_t other_triangles = 0;
    };

    // How far off, in pixels, what lies beyond the split may be where the eye has moved so far since.
    static float off_px(float moved_m, float split_m, float pixels_per_radian) {
        return moved_m * pixels_per_radian / (2 * split_m);
    }
    // The least distance from which on a view may be held while its eye moves so far.
    static float split_m(float moved_m, float pixels_per_radian) {
        return moved_m * pixels_per_radian / (2 * kMost_px);
    }

    // Where a view from there sees a picture, sky left out.
    static passes::DistanceWarp warp(const Sight& sight, const glm::mat4& clip_from_world, const glm::vec3& eye_m);
    // As shaders/held_distance.vert has it: the picture's coordinates at that place of the view.
    static glm::vec3 over_held(const passes::DistanceWarp& warp, glm::vec2 clip);  // times depth

    // Where the view sees the picture. None: it is of something else, too old, too far off, or would leave
    // a corner bare. now: the view's block of this frame.
    std::optional<passes::DistanceWarp> from_view(const View& view, const choose::ViewBlock& now, float scale) const;
    choose::Reach near() const;
    const Sight& sight() const { return sight_; }
    const gl::Texture2D& picture() const { return picture_; }

  private:
    friend class HeldDistances;
    Sight sight_;
    gl::Texture2D picture_;
    bool is_serving_ = false;
};

// Those of all views. They have turns, so that each frame draws its share: one of four views whole, of one view a
// strip.
class HeldDistances {
  public:
    static constexpr std::size_t kFrames = 4;  // from one turn of a view to its next

    // Holds what was drawn last, and tells each view's selection whether what is held of it serves: it is near then.
    // Skies have been asked before.
    void serve(const Frame& frame, const std::vector<HeldSky>& skies, std::vector<Selection>& selections);
    // Those in whose turn it is. step: of the plants' fineness. Leaves another framebuffer bound.
    void draw_in_turn(const Frame& frame, ViewPainter& painter, std::optional<int> step, Drawn& drawn);
    // What was drawn just now, where nothing else serves: a view is not drawn whole beside it.
    void show_at_once(const Frame& frame, const std::vector<HeldSky>& skies, std::vector<Selection>& selections);
    void drop();  // nothing is held, nor any memory kept

    const HeldDistance& of(std::size_t slot) const { return held_[slot]; }

  private:
    // What it has seen of a view's flight.
    struct Glide {
        std::weak_ptr<const GpuScene> scene;
        scene::Camera camera;
        glm::vec3 eye_step_m{0}, target_step_m{0};  // a frame
        bool is_known = false;
    };
    struct Turn {
        std::size_t slot;
        std::size_t strip, strips;
    };
    static std::optional<Turn> turn_of(std::size_t frame, std::size_t views);
    bool begin(const Frame& frame, const Turn& turn);
    void follow(const View& view, Glide& glide) const;
    void take();
    void serve_one(const Frame& frame, const std::vector<HeldSky>& skies, std::size_t slot, Selection& selection);

    std::size_t frames_ = 0;
    std::vector<HeldDistance> held_;  // one a view
    std::vector<Glide> glides_;       // likewise
    std::vector<std::unique_ptr<Stock>> stocks_;
    std::optional<std::size_t> drawing_;  // of which view
    bool is_drawn_ = false;               // all of it, and was not taken yet
    View view_;                           // as it is drawn
    HeldDistance::Sight sight_;
    gl::DeepTarget canvas_;
    gl::MultisampledTarget smooth_;  // where frames have several samples a pixel
    gl::TextureTarget copying_;
    gl::StreamBuffer block_{GL_UNIFORM_BUFFER};
};

}  // namespace quadrat::render
