// SPDX-License-Identifier: Apache-2.0
#include "stage/eye.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

#include "scene/colour.hpp"

namespace quadrat::stage {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 36;
constexpr int kBlock = 4;           // pixels a side
constexpr int kLandSamples = 129;   // a side: hills are there, pebbles are not
constexpr float kAlpha = 0.2F;      // detail: what has 64 pixels has no twigs
constexpr float kTexture = 0.5F;    // how much variation counts beside colour
constexpr float kColour = 2;        // a and b beside L: hue is seen well
constexpr std::size_t kBatch = 64;  // grown and not yet drawn
constexpr std::size_t kMost = 600;  // aspects remembered

float linear_of(std::uint8_t srgb) {
    const float c = static_cast<float>(srgb) / 255;
    return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F);
}

Sight sight_of(const mesh::Image& image) {
    Sight sight;
    for (int top = 0; top < image.height; top += kBlock)
        for (int left = 0; left < image.width; left += kBlock) {
            glm::vec3 sum{0};
            float squares = 0;
            for (int y = top; y < top + kBlock; ++y)
                for (int x = left; x < left + kBlock; ++x) {
                    const std::uint8_t* c = image.pixel(x, y);
                    const glm::vec3 lab = scene::oklab_from_linear({linear_of(c[0]), linear_of(c[1]), linear_of(c[2])});
                    sum += lab;
                    squares += lab.x * lab.x;
                }
            const glm::vec3 mean = sum / static_cast<float>(kBlock * kBlock);
            const float variance = std::max(0.0F, squares / static_cast<float>(kBlock * kBlock) - mean.x * mean.x);
            sight.insert(sight.end(), {mean.x, kColour * mean.y, kColour * mean.z, kTexture * std::sqrt(variance)});
        }
    return sight;
}

}  // namespace

Eye::Eye() : easel_(kWidth, kHeight) {}

void Eye::grow_missing(std::span<const genome::Recipe> landscapes) {
    if (grown_.size() > kMost) grown_.clear();
    std::map<nursery::AspectKey, const genome::Recipe*> missing;
    for (const genome::Recipe& landscape : landscapes)
        for (const genome::Aspect aspect : genome::kAspects) {
            nursery::AspectKey key = nursery::key_of(aspect, genome::candidate_of(landscape));
            if (!grown_.contains(key)) missing.emplace(std::move(key), &landscape);
        }
    std::vector<std::pair<nursery::AspectKey, const genome::Recipe*>> jobs(missing.begin(), missing.end());
    std::vector<nursery::Grown> made(jobs.size());
    tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
        const genome::Aspect aspect = std::get<0>(jobs[i].first);
        const genome::Recipe& recipe = *jobs[i].second;
        made[i] =
            nursery::grow_aspect(aspect, recipe.values, recipe.seeds[aspect], pictures::fineness_of(kLandSamples));
    });
    for (std::size_t i = 0; i < jobs.size(); ++i) grown_.emplace(std::move(jobs[i].first), std::move(made[i]));
}

std::shared_ptr<const scene::Scene> Eye::composed(const genome::Recipe& landscape) const {
    const genome::Candidate candidate = genome::candidate_of(landscape);
    const auto part = [&](genome::Aspect aspect) { return grown_.at(nursery::key_of(aspect, candidate)); };
    nursery::Plot plot{nursery::planting_of(landscape.seeds), landscape.flight,
                       std::get<0>(part(genome::Aspect::Trees)), std::get<1>(part(genome::Aspect::Land)),
                       std::get<2>(part(genome::Aspect::Sky))};
    nursery::lay_out(plot);
    return nursery::illuminated(plot, nursery::first_light(pictures::fineness_of(kLandSamples)));
}

std::vector<Sight> Eye::look(std::span<const genome::Recipe> landscapes) {
    std::vector<Sight> sights;
    for (std::size_t first = 0; first < landscapes.size(); first += kBatch) {
        const auto batch = landscapes.subspan(first, std::min(kBatch, landscapes.size() - first));
        grow_missing(batch);
        nursery::Scenes scenes(batch.size());
        tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t i) { scenes[i] = composed(batch[i]); });
        for (std::size_t i = 0; i < batch.size(); ++i) {
            pictures::Picture picture;
            picture.scenes = {batch[i]};
            picture.width = kWidth;
            picture.height = kHeight;
            picture.alpha = kAlpha;
            sights.push_back(sight_of(easel_.draw(picture, {scenes[i]})));
        }
    }
    return sights;
}

}  // namespace quadrat::stage
