// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "breeding/session.hpp"
#include "nursery/graph.hpp"

namespace quadrat::nursery {

// What can be grown of the next landscapes after some answers of a round.
struct Answered {
    genome::Pick answers;
    bool is_last_round;     // what comes is the Finale's landscape, not four to choose from
    bool is_last_question;  // one answer is missing
    bool has_code = false;  // the Finale's landscape is shown with its code, and grows from what that holds
};
// Its aspects that are known; where trees and land are, its layout; and where one answer is missing, each landscape
// that can come, in first light.
std::vector<Want> foreseen(const breeding::Session& session, const Answered& answered);

}  // namespace quadrat::nursery
