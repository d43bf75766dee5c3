// SPDX-License-Identifier: Apache-2.0
#include "nursery/head_start.hpp"

#include <utility>

#include "genome/scene_code.hpp"

namespace quadrat::nursery {
namespace {

// What will be ordered when these are all answers of this round.
Order order_after(const breeding::Session& session, const genome::Pick& answers, const Answered& answered) {
    if (answered.is_last_round) {
        breeding::Session after = session;
        after.next(answers);
        genome::Candidate favourite = after.favourite();
        if (answered.has_code) favourite.values = genome::rounded_for_code(favourite.values);
        return {{std::move(favourite)}, session.flight()};
    }
    const genome::Offer offer = session.preview(answers);
    return {{offer.candidates.begin(), offer.candidates.end()}, session.flight(offer)};
}

}  // namespace

HeadStart head_start(const breeding::Session& session, const Answered& answered) {
    HeadStart start{order_after(session, answered.answers, answered), {}, {}};
    // Aspects are independent: what was judged is final.
    for (const genome::Aspect aspect : genome::kAspects)
        if (answered.answers[aspect]) start.known.push_back(aspect);
    for (std::size_t i = 0; answered.is_last_question && i < genome::kCandidates; ++i) {
        genome::Pick all = answered.answers;
        all[genome::kAspects.back()] = i;
        start.possible.push_back(order_after(session, all, answered));
    }
    return start;
}

}  // namespace quadrat::nursery
