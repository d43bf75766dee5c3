// SPDX-License-Identifier: Apache-2.0
// Where the land meets the country around it, no edge shows in a picture: there was a hard dark slab behind it once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "genome/parameter_ids.hpp"
#include "genome/recipe.hpp"
#include "pictures/stage.hpp"
#include "scene/parameters.hpp"
#include "support/effort.hpp"
#include "synthesis/compose/view_rays.hpp"
#include "synthesis/grow.hpp"

namespace quadrat::tests {
namespace {

constexpr int kWidth = 480;
constexpr int kHeight = 270;
constexpr float kStep_m = 8;     // along the land's edge
constexpr std::size_t kRun = 8;  // places that are judged together, so that grain is no edge
constexpr float kAcross_px = 5;
constexpr int kTurns = 20;  // of the camera over each of ten lands

struct Crossing {
    glm::vec2 at_px{0};
    glm::vec2 out_px{0};  // unit, across the edge away from the land
};

class Seams : public Stage {
  protected:
    void SetUp() override {
        Stage::SetUp();
        open({kWidth, kHeight});
    }

    // Ground alone.
    mesh::Image ground_of(const std::shared_ptr<const render::GpuScene>& scene, const scene::Camera& camera) {
        render::Frame f = frame();
        render::View view;
        view.scene = scene;
        view.viewport = {0, 0, kWidth, kHeight};
        view.camera = camera;
        f.views = {view};
        f.measured.leaves = f.measured.wood = false;
        return drawn(f);
    }
};

class Lookout {
  public:
    Lookout(const scene::Land& land, const scene::Camera& camera)
        : land_(land),
          camera_(camera),
          clip_from_world_(scene::clip_from_view(camera, static_cast<float>(kWidth) / kHeight) *
                           scene::view_from_world(camera)) {}

    // Where the ground there is in the picture; nothing where it is not in it, or wet.
    std::optional<glm::vec2> pixel(glm::vec2 at_m) const {
        const glm::vec3 p = ground(at_m);
        if (p.y < 0.5F || scene::water_depth_m(land_, at_m) > 0) return std::nullopt;
        const glm::vec4 clip = clip_from_world_ * glm::vec4(p, 1);
        if (clip.w < 30) return std::nullopt;
        const glm::vec2 at{(0.5F + 0.5F * clip.x / clip.w) * kWidth, (0.5F - 0.5F * clip.y / clip.w) * kHeight};
        if (at.x < 32 || at.y < 32 || at.x > kWidth - 32 || at.y > kHeight - 32) return std::nullopt;
        return at;
    }

    bool is_hidden(glm::vec2 at_m) const {
        const glm::vec3 p = ground(at_m);
        const float distance_m = glm::distance(p, camera_.eye_m);
        const glm::vec3 ray = (p - camera_.eye_m) / distance_m;
        return synthesis::first_hit(land_, camera_.eye_m, ray).distance_m < 0.97F * distance_m;
    }

    // Runs of crossings of the land's four edges, or of lines so far within them, each in sight with the ground on both
    // sides.
    std::vector<std::vector<Crossing>> runs(float within_m = 0) const {
        const float edge_m = 0.5F * land_.side_m() - within_m;
        std::vector<std::vector<Crossing>> all;
        for (int side = 0; side < 4; ++side) {
            const glm::vec2 out{side == 0 ? 1 : side == 1 ? -1 : 0, side == 2 ? 1 : side == 3 ? -1 : 0};
            std::vector<Crossing> run;
            for (float a = -edge_m; a <= edge_m; a += kStep_m) {
                const auto crossing = crossing_at(edge_m * out + a * glm::vec2{-out.y, out.x}, out);
                if (!crossing) {
                    run.clear();
                    continue;
                }
                run.push_back(*crossing);
                if (run.size() < kRun) continue;
                all.push_back(std::move(run));
                run = {};
            }
        }
        return all;
    }

  private:
    std::optional<Crossing> crossing_at(glm::vec2 at_m, glm::vec2 out) const {
        constexpr float kBeside_m = 24;
        const auto at = pixel(at_m);
        const auto inner = pixel(at_m - kBeside_m * out);
        const auto outer = pixel(at_m + kBeside_m * out);
        const auto along = pixel(at_m + kStep_m * glm::vec2{-out.y, out.x});
        if (!at || !inner || !outer || !along || glm::distance(*along, *at) < 0.05F) return std::nullopt;
        const glm::vec2 way = glm::normalize(*along - *at);
        glm::vec2 across{-way.y, way.x};
        if (glm::dot(across, *outer - *inner) < 0) across = -across;
        // A crest hides what is behind it: there the ground ends for another reason.
        constexpr float kLeast_px = 2;
        if (glm::dot(across, *outer - *at) < kLeast_px || glm::dot(across, *at - *inner) < kLeast_px)
            return std::nullopt;
        if (is_hidden(at_m - kBeside_m * out) || is_hidden(at_m + kBeside_m * out)) return std::nullopt;
        return Crossing{*at, across};
    }

    glm::vec3 ground(glm::vec2 at_m) const { return {at_m.x, scene::ground_height_m(land_, at_m), at_m.y}; }

    const scene::Land& land_;
    const scene::Camera& camera_;
    glm::mat4 clip_from_world_;
};

float luma(const mesh::Image& image, glm::vec2 at_px) {
    const std::uint8_t* p = image.pixel(static_cast<int>(at_px.x), static_cast<int>(at_px.y));
    return (0.2126F * p[0] + 0.7152F * p[1] + 0.0722F * p[2]) / 255;
}

// How far luma steps where a run is moved so far outward, in the mean along it.
float step_of(const mesh::Image& image, const std::vector<Crossing>& run, float moved_px) {
    float sum = 0;
    for (const Crossing& c : run)
        for (const float reach_px : {0.4F, 0.7F, 1.0F}) {
            const glm::vec2 middle = c.at_px + moved_px * c.out_px;
            const glm::vec2 reach = 0.5F * reach_px * kAcross_px * c.out_px;
            sum += (luma(image, middle + reach) - luma(image, middle - reach)) / 3;
        }
    return std::abs(sum) / static_cast<float>(run.size());
}

// How much stronger than the strongest beside it an edge along the run is.
float over_beside(const mesh::Image& image, const std::vector<Crossing>& run) {
    float over = 0;
    float beside = 0;
    for (const float moved_px : {-1.5F, 0.0F, 1.5F}) over = std::max(over, step_of(image, run, moved_px));
    for (const float moved_px : {-18.0F, -13.0F, -8.0F, 8.0F, 13.0F, 18.0F})
        beside = std::max(beside, step_of(image, run, moved_px));
    return over - beside;
}

// Bare land under its sky: no plants, that nothing hides the seam.
std::shared_ptr<const scene::Scene> bare_land(std::uint64_t seed) {
    genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
    recipe.values.set(genome::ParameterId::rain_share, -4);
    recipe.values.set(genome::ParameterId::snowfall_share, -5);
    const scene::SceneParameters p = scene::realise(recipe.values);
    const scene::Fineness coarse{.land_samples = 129, .light_px = 64, .albedo_px = 256};
    const auto land =
        std::make_shared<scene::Land>(synthesis::grow_land(p.land, recipe.seeds[genome::Aspect::Land], coarse));
    const auto sky = std::make_shared<scene::Sky>(synthesis::grow_sky(p.sky, recipe.seeds[genome::Aspect::Sky]));
    return std::make_shared<scene::Scene>(synthesis::compose(
        std::make_shared<scene::Flora>(), land, sky, recipe.seeds[genome::Aspect::Trees], recipe.flight, coarse));
}

// High over the land's middle, each time turned on.
scene::Camera outward(const scene::Land& land, int turn) {
    const float angle = 2 * std::numbers::pi_v<float> * (static_cast<float>(turn) + 0.3F) / kTurns;
    const glm::vec2 ahead{std::sin(angle), -std::cos(angle)};
    const glm::vec2 at = 120.0F * ahead;
    const glm::vec3 eye{at.x, std::max(scene::ground_height_m(land, at), 0.0F) + 90, at.y};
    return {eye, eye + glm::vec3{ahead.x, -0.2F, ahead.y}, 50.0F};
}

// Of all runs along a line.
struct Edges {
    std::size_t runs = 0;
    std::size_t strong = 0;   // that stand out where somebody looks for them
    std::size_t visible = 0;  // that are stronger than what is beside them by more than grain makes
    double sum = 0;
    float worst = 0;

    bool add(float over) {
        worst = std::max(worst, over);
        sum += over;
        ++runs;
        visible += over > 0.02F;
        strong += over > 0.08F;
        return over > 0.08F;
    }
    double visible_share() const {
        return static_cast<double>(visible) / static_cast<double>(std::max<std::size_t>(runs, 1));
    }
    void tell(const char* what) const {
        std::printf("%zu runs of %s in sight; over what is beside them %.3f in the mean, %.3f at most; %zu by 0.02\n",
                    runs, what, sum / static_cast<double>(std::max<std::size_t>(runs, 1)), static_cast<double>(worst),
                    visible);
    }
};

// The same lines drawn within the land, where nothing meets, say how often ground has an edge along any line.
TEST_F(Seams, AreNoStrongerEdgesThanTheGroundBesideThemFromTwoHundredCameras) {
    Edges seam;
    Edges ground;
    for (std::uint64_t seed = 0; seed < of(10U); ++seed) {
        const auto scene = bare_land(seed);
        const auto on_gpu = uploaded(scene);
        for (int turn = 0; turn < kTurns; ++turn) {
            const scene::Camera camera = outward(*scene->land, turn);
            const Lookout lookout(*scene->land, camera);
            const auto found = lookout.runs();
            if (found.empty()) continue;
            const mesh::Image image = ground_of(on_gpu, camera);
            for (const auto& run : found)
                if (const float over = over_beside(image, run); seam.add(over))
                    std::printf("land %d, turn %d, at %.0f, %.0f: %.3f\n", static_cast<int>(seed), turn,
                                run.front().at_px.x, run.front().at_px.y, over);
            for (const float within_m : {60.0F, 100.0F, 140.0F})
                for (const auto& run : lookout.runs(within_m)) ground.add(over_beside(image, run));
        }
    }
    seam.tell("the seam");
    ground.tell("lines within the land");
    EXPECT_EQ(seam.strong, 0U);
    EXPECT_LE(seam.worst, ground.worst);
    EXPECT_LE(seam.visible_share(), ground.visible_share() + 0.01);
    EXPECT_GT(seam.runs, of(200U)) << "too little of the seam is seen";
}

}  // namespace
}  // namespace quadrat::tests
