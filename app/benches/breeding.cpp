// SPDX-License-Identifier: Apache-2.0
#include <tbb/global_control.h>

#include <algorithm>
#include <optional>

#include "benches/benches.hpp"
#include "breeding/session.hpp"

namespace quadrat::benches {
namespace {

using ::quadrat::breeding::DescribedScene;
using ::quadrat::breeding::WordMap;

// So many described scenes of every aspect: those there are, and others a little beside them.
std::vector<DescribedScene> described(std::size_t of_each) {
    std::vector<DescribedScene> scenes;
    for (const genome::Aspect aspect : genome::kAspects) {
        std::vector<DescribedScene> own;
        for (const DescribedScene& scene : ::quadrat::breeding::default_scenes())
            if (scene.aspect == aspect) own.push_back(scene);
        const std::size_t known = own.size();
        base::RandomStream chance{base::Seed{1}.child(name_of(aspect))};
        while (own.size() < of_each) {
            DescribedScene near = own[own.size() % known];
            near.name.clear();
            for (auto& word : near.words)
                if (word) word = std::clamp(*word + 0.3F * chance.normal(), -1.0F, 1.0F);
            for (const genome::Parameter& parameter : genome::parameter_table())
                if (parameter.aspect == aspect)
                    near.values.set(parameter.id,
                                    std::clamp(near.values[parameter.id] +
                                                   0.05F * chance.normal() * (parameter.max - parameter.min),
                                               parameter.min, parameter.max));
            own.push_back(std::move(near));
        }
        scenes.insert(scenes.end(), own.begin(), own.end());
    }
    return scenes;
}

}  // namespace

void breeding(Results& results) {
    const tbb::global_control one_core(tbb::global_control::max_allowed_parallelism, 1);
    const std::vector<DescribedScene> many = described(400);
    std::optional<WordMap> map;
    results.push_back({"breeding.train_default_ms",
                       least_ms(2, [&] { map.emplace(::quadrat::breeding::default_scenes()); }), "ms", 1});
    results.push_back({"breeding.train_400_ms", least_ms(1, [&] { map.emplace(many); }), "ms", 1});
    constexpr int kAsked = 200;
    base::RandomStream chance{base::Seed{2}};
    std::vector<genome::Description> asked(kAsked);
    for (genome::Description& words : asked)
        for (const genome::Word& word : genome::vocabulary()) words.set(word.id, chance.between(-1, 1));
    float sum = 0;
    const double ms = least_ms(5, [&] {
        for (const genome::Description& words : asked) sum += (*map)(words)[*genome::parameter_named("tree.height_m")];
    });
    results.push_back({"breeding.ask_us", sum > 0 ? 1e3 * ms / kAsked : 0, "us", 1});
    ::quadrat::breeding::BreederOptions options;
    options.kind = ::quadrat::breeding::BreederKind::Belief;
    options.genome = genome::Genome::Full;
    ::quadrat::breeding::Session session(::quadrat::breeding::Breeder(options), base::Seed{3});
    std::vector<double> rounds;
    for (int round = 0; round < 12; ++round) {
        genome::Pick pick;
        for (const genome::Aspect aspect : genome::kAspects) pick[aspect] = static_cast<std::size_t>(round) % 4;
        rounds.push_back(milliseconds_of([&] { session.next(pick); }));
    }
    results.push_back({"breeding.round_ms", machine::percentile(rounds, 0.5), "ms", 1});
}

}  // namespace quadrat::benches
