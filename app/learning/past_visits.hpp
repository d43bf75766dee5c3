// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "breeding/simulation/replay.hpp"

namespace quadrat::learning {

// The visits that a state folder tells of, bred again.
struct PastVisits {
    std::vector<breeding::PastVisit> visits;
    int tuned_differently = 0;  // by a breeder that this program's settings do not make: other four would come
    int by_sliders = 0;         // in which nothing was picked
};

// With the site's own word map, or that of before its last lesson. A curator's ranges and locks are not in the state:
// visits under them are counted as tuned differently. Throws InputError where there is no state file.
PastVisits past_visits_in(const std::filesystem::path& folder);

// What the newest visits after the numbered one ended with, `most` at most; those that can be bred again. One that is
// under way has not ended, nor has one that was interrupted, while no other has begun.
struct EndedVisit {
    genome::Candidate bred;
    genome::PerAspect<bool> judged{};
};
std::vector<EndedVisit> ended_visits_in(const std::filesystem::path& folder, std::int64_t after, std::size_t most);

// The number of the last visit that has ended, of those that a state folder tells of; 0 where there is none, or no
// state file.
std::int64_t last_visit_in(const std::filesystem::path& folder);

}  // namespace quadrat::learning
