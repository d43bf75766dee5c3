// SPDX-License-Identifier: Apache-2.0
#include "breeding/simulation/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace quadrat::breeding {
namespace {

constexpr int kTasks = 5;
constexpr int kRounds = 15;
constexpr int kRoundsWhenTired = 12;
constexpr double kContent = 0.5;        // who comes so close stops
constexpr double kEffort = 0.25;        // of a point of closeness that a point of difficulty outweighs
constexpr double kHalfInterval = 1.96;  // of standard errors: 95 %

struct Rating {
    double difficulty = 0;  // 1 easy to 5 hard: the rounds it took
    double closeness = 0;   // 1 to 5
};

Rating rated(const Played& played, int patience) {
    int rounds = patience;
    for (int round = 1; round <= patience; ++round)
        if (played.closeness[static_cast<std::size_t>(round - 1)] >= kContent) {
            rounds = round;
            break;
        }
    const double close = std::clamp(played.closeness[static_cast<std::size_t>(rounds - 1)], 0.0, 1.0);
    return {1 + 4.0 * (rounds - 1) / (kRounds - 1), 1 + 4 * close};
}

struct Ratings {
    Rating by_breeding;
    Rating by_sliders;
};

// One user's mean over the five tasks.
Ratings user_rates(const Tournament& tournament, int user, Method breeding, Method sliders) {
    Ratings mean;
    const bool breeds_first = user % 2 == 0;
    for (int task = 0; task < kTasks; ++task) {
        const int number = user * kTasks + task;
        const SimulatedVisitor visitor = visitor_of(tournament, number);
        const Rating bred =
            rated(play(tournament, visitor, number, breeding), breeds_first ? kRounds : kRoundsWhenTired);
        const Rating slid =
            rated(play(tournament, visitor, number, sliders), breeds_first ? kRoundsWhenTired : kRounds);
        mean.by_breeding.difficulty += bred.difficulty / kTasks;
        mean.by_breeding.closeness += bred.closeness / kTasks;
        mean.by_sliders.difficulty += slid.difficulty / kTasks;
        mean.by_sliders.closeness += slid.closeness / kTasks;
    }
    return mean;
}

std::string interval(const Estimate& estimate) {
    return fmt::format("{:+.2f} ± {:.2f}", estimate.value, kHalfInterval * estimate.error);
}

}  // namespace

std::vector<StudyRow> study(const Study& study, const std::function<void()>& played) {
    struct Way {
        std::string_view name;
        genome::Genome genome;
        Method method;
    };
    constexpr std::array kWays{Way{"PBIL, 21 parameters", genome::Genome::Classic, Method::Pbil},
                               Way{"belief, 21 parameters", genome::Genome::Classic, Method::Belief},
                               Way{"belief, the whole table", genome::Genome::Full, Method::Belief}};
    std::vector<StudyRow> rows;
    for (const Way& way : kWays)
        for (const Skill skill : {Skill::Skilled, Skill::Novice}) {
            Tournament tournament;
            tournament.genome = way.genome;
            tournament.seed = study.seed;
            const Method sliders = skill == Skill::Skilled ? Method::SlidersSkilled3 : Method::SlidersNovice3;
            std::vector<double> difficulty, closeness, preference;
            std::array<std::vector<double>, 2> by_order;
            for (int user = 0; user < study.users; ++user) {
                const Ratings r = user_rates(tournament, user, way.method, sliders);
                difficulty.push_back(r.by_breeding.difficulty - r.by_sliders.difficulty);
                closeness.push_back(r.by_breeding.closeness - r.by_sliders.closeness);
                const double better = closeness.back() - kEffort * difficulty.back();
                preference.push_back(better > 0 ? 1 : -1);
                by_order[static_cast<std::size_t>(user % 2)].push_back(closeness.back());
                played();
            }
            rows.push_back({std::string(way.name), skill, mean_of(difficulty), mean_of(closeness), mean_of(preference),
                            mean_of(by_order[0]), mean_of(by_order[1])});
        }
    return rows;
}

std::string table_of(const Study& study, const std::vector<StudyRow>& rows) {
    std::string text = fmt::format(
        "five tasks, both interfaces, both orders, {} simulated users; breeding - sliders, 95 % intervals\n"
        "{:<26}{:<10}{:>16}{:>16}{:>16}{:>18}{:>18}\n",
        study.users, "bred by", "sliders", "difficulty", "closeness", "preference", "closer, bred 1st",
        "closer, bred 2nd");
    for (const StudyRow& row : rows)
        text += fmt::format("{:<26}{:<10}{:>16}{:>16}{:>16}{:>18}{:>18}\n", row.bred_by,
                            row.skill == Skill::Skilled ? "skilled" : "novice", interval(row.difficulty),
                            interval(row.closeness), interval(row.preference), interval(row.bred_first),
                            interval(row.bred_second));
    return text +
           "the paper's ten people    sliders            -0.22           -0.75           -0.20\n"
           "Ratings are from 1 to 5; difficulty here is the rounds it took, 1 to 15, until a scene was half the way "
           "to\n"
           "the wish. A model of people, which tells how interfaces compare for users so made, and no more.\n";
}

}  // namespace quadrat::breeding
