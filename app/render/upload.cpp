// SPDX-License-Identifier: Apache-2.0
#include "render/upload.hpp"

#include <cassert>

#include "render/gl/slices.hpp"

namespace quadrat::render {
namespace {

// Slices hold references into the scene being made, so it stays behind its pointer.
class SceneUpload final : public Upload {
  public:
    SceneUpload(std::shared_ptr<const scene::Scene> source, std::shared_ptr<FloraShelf> shelf)
        : made_(std::make_shared<GpuScene>()) {
        passes::add_sky(slices_, made_->sky, source->sky);
        passes::add_land(slices_, made_->land, source);
        passes::add_fresh_water(slices_, made_->fresh_water, source);
        passes::add_stone(slices_, made_->stone, source);
        made_->flora = shelf->find(source->flora);
        if (!made_->flora) {
            made_->flora = std::make_shared<passes::FloraOnGpu>();
            passes::add_flora(slices_, *made_->flora, source->flora);
            slices_.add(0, [shelf, flora = made_->flora, grown = source->flora] { shelf->keep(grown, flora); });
        }
        made_->plants = source->plants;
        made_->air = light_and_air_of(*source);
    }

    void prepare() override { slices_.prepare_all(); }
    bool advance(std::size_t budget_bytes) override { return is_done_ = slices_.advance(budget_bytes); }
    std::shared_ptr<const GpuScene> take() override {
        assert(is_done_ && made_);
        return std::move(made_);
    }

  private:
    std::shared_ptr<GpuScene> made_;
    gl::Slices slices_;
    bool is_done_ = false;
};

}  // namespace

std::shared_ptr<passes::FloraOnGpu> FloraShelf::find(const std::shared_ptr<const scene::Flora>& grown) {
    std::erase_if(kept_, [](const Pair& pair) { return pair.on_gpu.expired() || pair.grown.expired(); });
    for (const Pair& pair : kept_)
        if (pair.grown.lock() == grown) return pair.on_gpu.lock();
    return nullptr;
}

void FloraShelf::keep(const std::shared_ptr<const scene::Flora>& grown,
                      const std::shared_ptr<passes::FloraOnGpu>& on_gpu) {
    kept_.push_back({grown, on_gpu});
}

std::unique_ptr<Upload> make_upload(std::shared_ptr<const scene::Scene> scene, std::shared_ptr<FloraShelf> shelf) {
    return std::make_unique<SceneUpload>(std::move(scene), std::move(shelf));
}

}  // namespace quadrat::render
