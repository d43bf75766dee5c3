// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <vector>

#include "render/gpu_scene.hpp"

namespace quadrat::render {

// What is on the GPU already: scenes that inherited one flora, or stand on one land, hold it once.
template <typename Grown, typename OnGpu>
class Shelf {
  public:
    std::shared_ptr<const OnGpu> find(const std::shared_ptr<const Grown>& grown) {
        std::erase_if(kept_, [](const Pair& pair) { return pair.on_gpu.expired() || pair.grown.expired(); });
        for (const Pair& pair : kept_)
            if (pair.grown.lock() == grown) return pair.on_gpu.lock();
        return nullptr;
    }
    void keep(const std::shared_ptr<const Grown>& grown, const std::shared_ptr<const OnGpu>& on_gpu) {
        kept_.push_back({grown, on_gpu});
    }

  private:
    struct Pair {
        std::weak_ptr<const Grown> grown;
        std::weak_ptr<const OnGpu> on_gpu;
    };
    std::vector<Pair> kept_;
};

struct Shelves {
    Shelf<scene::Flora, passes::FloraOnGpu> floras;
    Shelf<scene::Land, CountryOnGpu> countries;
    Shelf<scene::Sky, passes::SkyOnGpu> skies;
    Shelf<scene::Land, passes::MaterialOnGpu> materials;
    passes::GroundPainter painter;
    gl::BufferPool buffers;
};

std::unique_ptr<SceneUpload> make_upload(std::shared_ptr<const scene::Scene> scene, std::shared_ptr<Shelves> shelves);
std::unique_ptr<Upload> make_upload(const scene::Ground& ground, std::shared_ptr<Shelves> shelves);

}  // namespace quadrat::render
