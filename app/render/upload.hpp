// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>
#include <memory>
#include <variant>
#include <vector>

#include "render/gpu_scene.hpp"

namespace quadrat::render {

// What is on the GPU already: scenes that inherited one flora, or stand on one land, hold it once. Under: what else it
// depends on.
template <typename Grown, typename OnGpu, typename Under = std::monostate>
class Shelf {
  public:
    std::shared_ptr<const OnGpu> find(const std::shared_ptr<const Grown>& grown, const Under& under) {
        std::erase_if(kept_, [](const Kept& kept) { return kept.on_gpu.expired() || kept.grown.expired(); });
        for (const Kept& kept : kept_)
            if (kept.grown.lock() == grown && kept.under == under) return kept.on_gpu.lock();
        return nullptr;
    }
    void keep(const std::shared_ptr<const Grown>& grown, const Under& under,
              const std::shared_ptr<const OnGpu>& on_gpu) {
        kept_.push_back({grown, under, on_gpu});
    }

  private:
    struct Kept {
        std::weak_ptr<const Grown> grown;
        Under under;
        std::weak_ptr<const OnGpu> on_gpu;
    };
    std::vector<Kept> kept_;
};

struct Shelves {
    GroundBy ground = GroundBy::Blocks;  // of which the countries are made ready to be drawn
    Shelf<scene::Flora, passes::FloraOnGpu> floras;
    Shelf<scene::Land, CountryOnGpu> countries;
    Shelf<scene::Sky, passes::SkyOnGpu> skies;
    Shelf<scene::Land, passes::GrainOnGpu, glm::vec3> grains;  // under a sun: a first light's and the refined one's
    gl::TexturePool grain_textures{8};
    gl::TexturePool cloud_textures{8};
    gl::TexturePool ground_pictures{20};  // as many as one round takes ahead, and what it shows
    gl::TexturePool mirror_pictures{8};
    gl::BufferPool buffers;
};

std::unique_ptr<SceneUpload> make_upload(std::shared_ptr<const scene::Scene> scene, std::shared_ptr<Shelves> shelves);
std::unique_ptr<Upload> make_upload(const scene::Ground& ground, std::shared_ptr<Shelves> shelves);

}  // namespace quadrat::render
