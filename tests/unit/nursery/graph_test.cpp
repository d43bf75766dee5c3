// SPDX-License-Identifier: Apache-2.0
// What is done next, and what is forgotten: without threads, and on grains of land.
#include "nursery/graph.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace quadrat::nursery {
namespace {

using genome::Aspect;
using testing::IsEmpty;

const scene::Fineness kFine{33, 256, 64};

Landscapes four(std::uint64_t seed) {
    std::vector<genome::Candidate> all;
    for (std::size_t i = 0; i < genome::kCandidates; ++i)
        all.push_back(genome::candidate_of(genome::random_recipe(base::Seed{seed}.child(i))));
    return landscapes_of(all, base::Seed{seed});
}

void do_all(Graph& graph, std::vector<Job> jobs) {
    for (Job& job : jobs) carry_out(job, kFine);
    graph.take(std::move(jobs));
}

// The stages of the jobs that lead there, so many at once.
std::vector<Stage> work_through(Graph& graph, std::size_t at_once = 2) {
    std::vector<Stage> stages;
    for (auto jobs = graph.next(at_once); !jobs.empty(); jobs = graph.next(at_once)) {
        for (const Job& job : jobs) stages.push_back(job.stage);
        do_all(graph, std::move(jobs));
    }
    return stages;
}

std::ptrdiff_t count(const std::vector<Stage>& stages, Stage stage) { return std::ranges::count(stages, stage); }

TEST(Graph, GrowsAspectsBeforeLightAndNothingTwice) {
    Graph graph(kFine);
    const Landscapes landscapes = four(1);
    graph.want(wants_for(landscapes, Stage::FirstLight, Urgency::Awaited));
    EXPECT_TRUE(graph.has_unfinished_awaited());
    EXPECT_EQ(graph.progress(), 0);
    const std::vector<Stage> stages = work_through(graph);
    EXPECT_EQ(count(stages, Stage::Aspects), 12);
    EXPECT_EQ(count(stages, Stage::FirstLight), 4);
    EXPECT_EQ(stages.size(), 16U);
    EXPECT_TRUE(std::ranges::is_sorted(stages));
    EXPECT_FALSE(graph.has_unfinished_awaited());
    EXPECT_EQ(graph.progress(), 1);
    graph.want(wants_for(landscapes, Stage::FullLight, Urgency::Shown));
    EXPECT_EQ(work_through(graph), std::vector<Stage>(4, Stage::FullLight));
}

TEST(Graph, DoesWhatIsMoreUrgentFirst) {
    Graph graph(kFine);
    const Landscapes awaited = four(1);
    const Landscapes spare = four(2);
    auto wants = wants_for(spare, Stage::FullLight, Urgency::Spare);
    std::ranges::copy(wants_for(awaited, Stage::FirstLight, Urgency::Awaited), std::back_inserter(wants));
    graph.want(wants);
    while (graph.has_unfinished_awaited()) {
        auto jobs = graph.next(100);
        for (const Job& job : jobs) ASSERT_TRUE(std::ranges::find(awaited, job.landscape) != awaited.end());
        do_all(graph, std::move(jobs));
    }
    EXPECT_THAT(graph.next(100, Urgency::Coming), IsEmpty());
    EXPECT_FALSE(graph.next(100).empty());
}

TEST(Graph, GrowsOfWhatIsForeseenWhatIsKnown) {
    Graph graph(kFine);
    auto wants = wants_for(four(1), Stage::Aspects, Urgency::Coming);
    for (Want& want : wants) want.known = {{true, false, false}};
    graph.foresee(wants);
    EXPECT_EQ(work_through(graph), std::vector<Stage>(4, Stage::Aspects));
    EXPECT_EQ(graph.kept(), 4U);
    EXPECT_THAT(graph.ahead().grounds, IsEmpty());
    for (Want& want : wants) {
        want.known[Aspect::Land] = true;
        want.stage = Stage::Layout;
    }
    graph.foresee(wants);
    const std::vector<Stage> stages = work_through(graph);
    EXPECT_EQ(count(stages, Stage::Aspects), 4) << "the trees stand already";
    EXPECT_EQ(count(stages, Stage::Layout), 4);
    EXPECT_EQ(graph.ahead().grounds.size(), 4U);
}

TEST(Graph, OneThingThatSeveralWantIsOneThing) {
    Graph graph(kFine);
    Landscapes twice = four(1);
    twice[1] = twice[0];
    twice[3] = landscape_of(twice[2]->candidate, base::Seed{99});  // another flight over the same land
    graph.want(wants_for(twice, Stage::FirstLight, Urgency::Awaited));
    const std::vector<Stage> stages = work_through(graph, 100);
    EXPECT_EQ(count(stages, Stage::Aspects), 6);
    EXPECT_EQ(count(stages, Stage::FirstLight), 3);
}

TEST(Graph, KeepsWhatWasWorkedOnWhileItCeasedToBeWantedOnlyWhereItIsAnAspect) {
    Graph graph(kFine);
    const Landscapes landscapes = four(1);
    graph.want(wants_for(landscapes, Stage::FirstLight, Urgency::Awaited));
    while (graph.next(100).front().stage == Stage::Aspects) do_all(graph, graph.next(100));
    auto lights = graph.next(100);
    graph.want({});
    do_all(graph, std::move(lights));
    EXPECT_FALSE(graph.find(landscapes));
    EXPECT_EQ(graph.kept(), 12U);
    graph.want(wants_for(landscapes, Stage::FirstLight, Urgency::Awaited));
    EXPECT_EQ(work_through(graph, 100), std::vector<Stage>(4, Stage::FirstLight));
}

TEST(Graph, ForgetsNoAspectThatIsStillNeeded) {
    Graph graph(kFine);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        graph.want(wants_for(four(seed), Stage::FirstLight, Urgency::Awaited));
        work_through(graph, 100);
        EXPECT_LE(graph.kept(), Graph::kAspectsKept);
        EXPECT_TRUE(graph.is_there());
    }
}

}  // namespace
}  // namespace quadrat::nursery
