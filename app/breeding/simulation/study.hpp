// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "breeding/simulation/tournament.hpp"

namespace quadrat::breeding {

// The user test of "Genetic selection of parametric scenes" (2003), section 4, table 1, done by simulated users: each
// comes to five target scenes, once by breeding and once by sliders, half of them in the one order and half in the
// other, and rates difficulty and closeness from 1 to 5. It is a model: how a rating follows from closeness and rounds
// is ours, and so is that a user has a fifth less patience for what comes second.
struct Study {
    int users = 60;
    base::Seed seed{1};
};

enum class Skill { Skilled, Novice };  // knows which slider is most wrong, or takes them in any order; three a round

// AI - manual, as in the paper.
struct StudyRow {
    std::string bred_by;
    Skill skill = Skill::Skilled;
    Estimate difficulty;
    Estimate closeness;
    Estimate preference;  // 1 who would rather breed, -1 who would rather have sliders
    Estimate bred_first;  // closeness, of those who bred first
    Estimate bred_second;
};

// The paper's own way (21 parameters, PBIL) and ours (the whole table, belief), against sliders of both skills.
// `played` is told after each user.
std::vector<StudyRow> study(const Study& study, const std::function<void()>& played);
std::string table_of(const Study& study, const std::vector<StudyRow>& rows);

}  // namespace quadrat::breeding
