// SPDX-License-Identifier: Apache-2.0
#include "nursery/foreseen.hpp"

#include <utility>

#include "genome/scene_code.hpp"

namespace quadrat::nursery {
namespace {

// What will be shown when these are all answers of this round.
Landscapes landscapes_after(const breeding::Session& session, const genome::Pick& answers, const Answered& answered) {
    if (answered.is_last_round) {
        breeding::Session after = session;
        after.next(answers);
        genome::Candidate favourite = after.favourite();
        if (answered.has_code) favourite.values = genome::rounded_for_code(favourite.values);
        return {landscape_of(std::move(favourite), session.flight())};
    }
    const genome::Offer offer = session.preview(answers);
    return landscapes_of({offer.candidates.begin(), offer.candidates.end()}, session.flight(offer));
}

}  // namespace

std::vector<Want> foreseen(const breeding::Session& session, const Answered& answered) {
    genome::PerAspect<bool> known;
    // Aspects are independent: what was judged is final.
    for (const genome::Aspect aspect : genome::kAspects) known[aspect] = answered.answers[aspect].has_value();
    const bool can_be_laid_out = known[genome::Aspect::Trees] && known[genome::Aspect::Land];
    std::vector<Want> wants;
    for (auto& landscape : landscapes_after(session, answered.answers, answered))
        wants.push_back(
            {std::move(landscape), can_be_laid_out ? Stage::Layout : Stage::Aspects, Urgency::Coming, known});
    for (std::size_t i = 0; answered.is_last_question && i < genome::kCandidates; ++i) {
        genome::Pick all = answered.answers;
        all[genome::kAspects.back()] = i;
        for (auto& landscape : landscapes_after(session, all, answered))
            wants.push_back({std::move(landscape), Stage::FirstLight, Urgency::Coming});
    }
    return wants;
}

}  // namespace quadrat::nursery
