// SPDX-License-Identifier: Apache-2.0
#include "benches/settled.hpp"

#include <algorithm>

#include "genome/parameter_ids.hpp"
#include "nursery/growing.hpp"

namespace quadrat::benches {
namespace {

constexpr float kAge = 0.5F;  // a village of some sixty houses
constexpr std::uint64_t kSeed = 11;

nursery::Scenes villages() {
    nursery::Scenes scenes;
    for (std::uint64_t i = 0; i < 40 && scenes.size() < genome::kCandidates; ++i) {
        genome::Recipe recipe = genome::random_recipe(base::Seed{kSeed}.child(i));
        recipe.values.set(genome::ParameterId::settle_age, kAge);
        const auto scene = nursery::grow(recipe);
        if (scene->land->settlement.houses.size() > 20) scenes.push_back(scene);
    }
    return scenes;
}

// The same, but nothing that has been built: paths and gardens stay.
nursery::Scenes unbuilt(const nursery::Scenes& scenes) {
    nursery::Scenes bare;
    for (const auto& scene : scenes) {
        const auto copy = std::make_shared<scene::Scene>(*scene);
        const auto land = std::make_shared<scene::Land>(*scene->land);
        land->settlement = {};
        copy->land = land;
        bare.push_back(copy);
    }
    return bare;
}

struct Flown {
    double cpu_ms = 0;
    double triangles = 0;  // of a frame, in the mean
};

Flown flown(FourViews& views, int first) {
    constexpr int kFrames = 12;  // in which each view's distance has its turn three times
    Flown sum;
    double cpu_s = 0;
    for (int n = -kFrames; n < kFrames; ++n) {
        if (n == 0) cpu_s = machine::cpu_seconds();
        views.look(10 + static_cast<float>(first + n) / 30);
        const render::Drawn drawn = views.draw();
        if (n >= 0) sum.triangles += static_cast<double>(drawn.triangles) / kFrames;
    }
    sum.cpu_ms = 1e3 * (machine::cpu_seconds() - cpu_s) / kFrames;
    return sum;
}

}  // namespace

void settled(Results& results, FourViews& views) {
    constexpr int kTurns = 10;
    const nursery::Scenes built = villages();
    views.show(unbuilt(built));
    std::vector<render::View> bare_views = views.picture.views;
    views.show(built);
    std::vector<double> ratios, with_ms, without_ms;
    double with_triangles = 0;
    double without_triangles = 0;
    for (int turn = 0; turn < kTurns; ++turn) {
        const Flown with = flown(views, 12 * turn);
        std::swap(views.picture.views, bare_views);
        const Flown without = flown(views, 12 * turn);
        std::swap(views.picture.views, bare_views);
        with_ms.push_back(with.cpu_ms);
        without_ms.push_back(without.cpu_ms);
        ratios.push_back(with.cpu_ms / without.cpu_ms);
        with_triangles += with.triangles / kTurns;
        without_triangles += without.triangles / kTurns;
    }
    std::size_t houses = 0;
    for (const auto& scene : built) houses += scene->land->settlement.houses.size();
    const auto add = [&](const char* row, double value, std::string unit) {
        results.push_back({row, value, std::move(unit), cores()});
    };
    add("frame.settled_cpu_ms", machine::percentile(with_ms, 0.5), "ms of all cores, four villages");
    add("frame.unbuilt_cpu_ms", machine::percentile(without_ms, 0.5), "ms of all cores, the same without houses");
    add("frame.settled_ratio", machine::percentile(ratios, 0.5), "of it, the median of the turns'");
    add("frame.settled_triangles", with_triangles, "triangles in the mean");
    add("frame.unbuilt_triangles", without_triangles, "triangles in the mean");
    add("frame.settled_houses", static_cast<double>(houses), "houses in all");
}

}  // namespace quadrat::benches
