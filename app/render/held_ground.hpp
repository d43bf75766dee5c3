// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/mat4x4.hpp>
#include <memory>
#include <vector>

#include "render/choose/allowance.hpp"
#include "render/choose/hold.hpp"
#include "render/choose/horizon.hpp"
#include "render/gl/buffer.hpp"
#include "render/gpu_scene.hpp"
#include "render/passes/grid.hpp"

namespace quadrat::render {

// What is drawn of land, surround, stone and houses in one of a frame's views, kept from frame to frame while it
// serves.
class HeldGround {
  public:
    struct Wish {
        choose::Allowance allowance = {};
        float pixels_per_radian = 500;
        float aspect_ratio = 1;  // of the view
        choose::Reach reach = {};
        glm::vec2 strip{-1, 1};  // of the view, clip x
        float growth = 1;        // of its settlement: the share of the houses that stand
        friend bool operator==(const Wish&, const Wish&) = default;
    };
    void update(const View& view, const glm::mat4& clip_from_world, const Wish& wish);
    void drop();  // nothing is drawn

    const gl::StreamBuffer& indices() const { return indices_; }
    const choose::IndexRange& land() const { return land_; }
    const choose::IndexRange& surround() const { return surround_; }
    const choose::IndexRange& stone() const { return stone_; }
    const choose::IndexRange& houses() const { return houses_; }
    const choose::Horizon& horizon() const { return horizon_; }  // of land and surround
    float grain_m() const { return grain_m_; }                   // how far the land's grain is seen
    // The land's triangles a level, for wires: sorted by it, in the index stream of its own.
    const std::vector<choose::IndexRange>& land_by_level() const { return land_by_level_; }
    const gl::StreamBuffer& level_indices() const { return level_indices_; }
    void sort_by_level(const GpuScene& scene);
    std::size_t triangles() const { return chosen_.size() / 3; }
    std::size_t sent_bytes() const { return sent_bytes_; }  // by the last update

  private:
    choose::IndexRange choose(const passes::GridOnGpu& grid, const choose::Frustum& frustum,
                              const choose::Blocks::Wish& wish);
    choose::IndexRange choose_by_roam(const mesh::Roam& roam, const choose::Frustum& frustum,
                                      const choose::Blocks::Wish& wish);

    void look_around(const GpuScene& scene, const scene::Camera& camera, const choose::Frustum& frustum, float sunk);

    std::weak_ptr<const GpuScene> scene_;
    Wish wish_;
    choose::Hold hold_;
    choose::Hold sight_{choose::Horizon::kMoved_m, choose::Horizon::kTurned_rad};
    choose::Horizon horizon_;
    float sunk_ = 0;  // of the horizon
    std::vector<std::uint8_t> hidden_land_, hidden_surround_;
    std::vector<std::uint32_t> chosen_;
    std::vector<std::uint32_t> farther_;  // kept for its memory only
    gl::StreamBuffer indices_{GL_ELEMENT_ARRAY_BUFFER};
    gl::StreamBuffer level_indices_{GL_ELEMENT_ARRAY_BUFFER};
    std::vector<choose::IndexRange> land_by_level_;
    choose::IndexRange land_, surround_, stone_, houses_;
    float grain_m_ = 1;
    std::size_t sent_bytes_ = 0;
};

}  // namespace quadrat::render
