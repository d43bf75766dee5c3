// SPDX-License-Identifier: Apache-2.0
#include "benches/benches.hpp"
#include "nursery/growing.hpp"

namespace quadrat::benches {

void generation(Results& results) {
    std::vector<double> samples;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        samples.push_back(milliseconds_of([&] {
            using nursery::Stage;
            using nursery::Urgency;
            nursery::Nursery nursery;
            nursery.want(nursery::wants_for(nursery::landscapes_of(random_candidates(seed), base::Seed{seed}),
                                            Stage::FullLight, Urgency::Awaited));
            nursery.wait();
        }));
    }
    results.push_back({"generation.cold_ms", machine::percentile(samples, 0.5), "ms", cores()});
}

}  // namespace quadrat::benches
