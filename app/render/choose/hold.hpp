// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <optional>

#include "render/choose/frustum.hpp"
#include "scene/camera.hpp"

namespace quadrat::render::choose {

// What was chosen of the ground for one view serves the next frames too, as long as the eye has hardly moved: it was
// chosen for a view a little wider, and vertices ease by where the eye is now.
class Hold {
  public:
    // Neither moved by more than this nor turned by more than that; together less than the wider view's margin for
    // ground 4 m away, which is the nearest that an eye at a man's height sees.
    static constexpr float kMoved_m = 0.07F;
    static constexpr float kTurned_rad = 0.007F;

    explicit Hold(float moved_m = kMoved_m, float turned_rad = kTurned_rad)
        : moved_m_(moved_m), turned_rad_(turned_rad) {}

    bool serves(const scene::Camera& camera) const {
        return chosen_for_ && chosen_for_->vertical_fov_deg == camera.vertical_fov_deg &&
               glm::distance(chosen_for_->eye_m, camera.eye_m) < moved_m_ &&
               glm::distance(ahead(*chosen_for_), ahead(camera)) < turned_rad_;
    }
    void choose(const scene::Camera& camera) { chosen_for_ = camera; }
    void drop() { chosen_for_.reset(); }

    static Frustum wider(glm::mat4 clip_from_world) {
        constexpr float kNarrowed = 0.92F;
        for (int column = 0; column < 4; ++column) {
            clip_from_world[column].x *= kNarrowed;
            clip_from_world[column].y *= kNarrowed;
        }
        return Frustum(clip_from_world);
    }

  private:
    static glm::vec3 ahead(const scene::Camera& camera) { return glm::normalize(camera.target_m - camera.eye_m); }
    float moved_m_;
    float turned_rad_;
    std::optional<scene::Camera> chosen_for_;
};

}  // namespace quadrat::render::choose
