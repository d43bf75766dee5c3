// SPDX-License-Identifier: Apache-2.0
#include "render/upload.hpp"

#include <cassert>
#include <utility>

#include "render/gl/slices.hpp"

namespace quadrat::render {
namespace {

// What is on the shelf; or what add(slices, new one) brings, and puts there when it is whole.
template <typename Grown, typename OnGpu, typename Under, typename Add>
std::shared_ptr<const OnGpu> shelved(gl::Slices& slices, const std::shared_ptr<Shelves>& shelves,
                                     Shelf<Grown, OnGpu, Under> Shelves::*shelf,
                                     const std::shared_ptr<const Grown>& grown, const Add& add,
                                     const Under& under = {}) {
    if (auto found = ((*shelves).*shelf).find(grown, under)) return found;
    const auto made = std::make_shared<OnGpu>();
    add(slices, *made, grown);
    slices.add(0, [shelves, shelf, grown, under, made] { ((*shelves).*shelf).keep(grown, under, made); });
    return made;
}

// Slices hold references into what is made, so it stays behind pointers.
struct GroundOnGpu {
    std::shared_ptr<const CountryOnGpu> country;
    std::shared_ptr<const passes::FloraOnGpu> flora;

    GroundOnGpu(gl::Slices& slices, const scene::Ground& ground, const std::shared_ptr<Shelves>& shelves)
        : country(shelved(slices, shelves, &Shelves::countries, ground.land,
                          [&](gl::Slices& to, CountryOnGpu& made, const std::shared_ptr<const scene::Land>& land) {
                              const std::shared_ptr<gl::BufferPool> pool{shelves, &shelves->buffers};
                              passes::add_land(to, made.land, pool, land);
                              if (shelves->ground == GroundBy::Roam) passes::add_roam(to, made.land, land);
                              passes::add_fresh_water(to, made.fresh_water, pool, land);
                              passes::add_stone(to, made.stone, land);
                              passes::add_houses(to, made.houses, land);
                              passes::add_smoke(to, made.smoke, land);
                          })),
          flora(shelved(slices, shelves, &Shelves::floras, ground.flora, passes::add_flora)) {}
};

class GroundUpload final : public Upload {
  public:
    GroundUpload(const scene::Ground& ground, const std::shared_ptr<Shelves>& shelves)
        : made_(slices_, ground, shelves) {}

    void prepare() override { slices_.prepare_all(); }
    bool advance(std::size_t budget_bytes, const std::function<bool()>& has_time) override {
        return slices_.advance(budget_bytes, has_time);
    }

  private:
    gl::Slices slices_;
    GroundOnGpu made_;
};

class WholeUpload final : public SceneUpload {
  public:
    WholeUpload(const std::shared_ptr<const scene::Scene>& source, const std::shared_ptr<Shelves>& shelves)
        : made_(std::make_shared<GpuScene>()) {
        const GroundOnGpu ground(slices_, {source->flora, source->land}, shelves);
        made_->country = ground.country;
        made_->flora = ground.flora;
        made_->plants = {source, &source->plants};
        slices_.prepare([made = made_.get(), source] { made->air = light_and_air_of(*source); });
        passes::add_cover(slices_, made_->cover, source);
        passes::add_mirror(slices_, made_->mirror, {shelves, &shelves->mirror_pictures}, source);
        made_->sky = shelved(slices_, shelves, &Shelves::skies, source->sky,
                             [&](gl::Slices& to, passes::SkyOnGpu& made, const std::shared_ptr<const scene::Sky>& sky) {
                                 passes::add_sky(to, made, {shelves, &shelves->cloud_textures}, sky);
                             });
        const glm::vec3 to_sun = source->sky->sun_direction;
        made_->ground.grain = shelved(
            slices_, shelves, &Shelves::grains, source->land,
            [&](gl::Slices& to, passes::GrainOnGpu& grain, const std::shared_ptr<const scene::Land>& land) {
                passes::add_grain(to, grain, {shelves, &shelves->grain_textures}, land, to_sun);
            },
            to_sun);
        passes::add_ground_picture(slices_, made_->ground, {shelves, &shelves->ground_pictures}, source);
    }

    void prepare() override { slices_.prepare_all(); }
    bool advance(std::size_t budget_bytes, const std::function<bool()>& has_time) override {
        return is_done_ = slices_.advance(budget_bytes, has_time);
    }
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

std::unique_ptr<SceneUpload> make_upload(std::shared_ptr<const scene::Scene> scene, std::shared_ptr<Shelves> shelves) {
    return std::make_unique<WholeUpload>(scene, shelves);
}

std::unique_ptr<Upload> make_upload(const scene::Ground& ground, std::shared_ptr<Shelves> shelves) {
    return std::make_unique<GroundUpload>(ground, shelves);
}

}  // namespace quadrat::render
