// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <vector>

#include "render/gpu_scene.hpp"

namespace quadrat::render {

// Floras that are on the GPU already: four scenes that inherited one flora hold it once.
class FloraShelf {
  public:
    std::shared_ptr<passes::FloraOnGpu> find(const std::shared_ptr<const scene::Flora>& grown);
    void keep(const std::shared_ptr<const scene::Flora>& grown, const std::shared_ptr<passes::FloraOnGpu>& on_gpu);

  private:
    struct Pair {
        std::weak_ptr<const scene::Flora> grown;
        std::weak_ptr<passes::FloraOnGpu> on_gpu;
    };
    std::vector<Pair> kept_;
};

std::unique_ptr<Upload> make_upload(std::shared_ptr<const scene::Scene> scene, std::shared_ptr<FloraShelf> shelf);

}  // namespace quadrat::render
