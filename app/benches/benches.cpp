// SPDX-License-Identifier: Apache-2.0
#include "benches/benches.hpp"

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <thread>

namespace quadrat::benches {

double milliseconds_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double least_ms(int runs, const std::function<void()>& work) {
    double least = std::numeric_limits<double>::max();
    for (int i = 0; i < runs; ++i) least = std::min(least, milliseconds_of(work));
    return least;
}

int cores() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

double median_over_scenes(int scenes, const std::function<void(const genome::Recipe&)>& work) {
    std::vector<double> samples;
    for (int i = 0; i < scenes; ++i) {
        const genome::Recipe recipe = genome::random_recipe(base::Seed{static_cast<std::uint64_t>(i) + 1});
        samples.push_back(milliseconds_of([&] { work(recipe); }));
    }
    return machine::percentile(samples, 0.5);
}

void over_threads(Results& results, const std::string& name, const std::function<void(const genome::Recipe&)>& work) {
    constexpr int kScenes = 9;
    for (const int threads : {1, cores()}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                        static_cast<std::size_t>(threads));
        results.push_back({name, median_over_scenes(kScenes, work), "ms", threads});
        if (threads == cores()) break;
    }
}

std::vector<genome::Candidate> random_candidates(std::uint64_t seed) {
    std::vector<genome::Candidate> candidates;
    for (std::size_t i = 0; i < genome::kCandidates; ++i)
        candidates.push_back(genome::candidate_of(genome::random_recipe(base::Seed{seed}.child(i))));
    return candidates;
}

}  // namespace quadrat::benches
