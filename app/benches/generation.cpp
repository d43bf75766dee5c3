// SPDX-License-Identifier: Apache-2.0
#include "benches/benches.hpp"
#include "nursery/growing.hpp"

namespace quadrat::benches {

void generation(Results& results) {
    std::vector<double> samples;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        samples.push_back(milliseconds_of([&] {
            nursery::Grower grower;
            grower.order({random_candidates(seed), base::Seed{seed}});
            grower.wait();
        }));
    }
    results.push_back({"generation.cold_ms", machine::percentile(samples, 0.5), "ms", cores()});
}

}  // namespace quadrat::benches
