// SPDX-License-Identifier: Apache-2.0
#include "learning/night_school.hpp"

namespace quadrat::learning {

void NightSchool::begin(Keeper& keeper) {
    night_ = night_of(local_time_());
    asked_ = keeper.post(
        [school = school_](const archive::Archive& archive) -> archive::Trouble {
            school->begin(archive.word_answers());
            return std::nullopt;
        },
        Keeper::Urgency::Written);
}

bool NightSchool::look(Keeper& keeper, bool is_anybody_there) {
    const bool has_learnt = school_->take();
    if (!is_anybody_there && night_of(local_time_()) != night_) begin(keeper);
    return has_learnt;
}

void NightSchool::wait(Keeper& keeper) {
    keeper.wait(asked_);
    school_->wait();
}

}  // namespace quadrat::learning
