// SPDX-License-Identifier: Apache-2.0
#include "learning/school.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/process.hpp"
#include "unit/learning/answers.hpp"

namespace quadrat::learning {
namespace {

using genome::Aspect;
using genome::WordId;
using namespace std::chrono_literals;

TEST(School, HasTheDefaultMapWhereNothingWasTaught) {
    const tests::TemporaryFolder folder;
    School school(folder.path());
    EXPECT_EQ(school.map(), breeding::default_word_map());
    EXPECT_FALSE(learn(school, {}));
    EXPECT_FALSE(std::filesystem::exists(folder / "words.json")) << "nothing to keep";
}

TEST(School, LearnsKeepsTheMapOnDiskAndTheOneBeforeBesideIt) {
    const tests::TemporaryFolder folder;
    School school(folder.path());
    ASSERT_TRUE(learn(school, sensible_answers(30)));
    EXPECT_EQ(site_words(folder.path()).lessons.visitors.size(), 30U);
    genome::Description words;
    words.set(WordId::wet, 0.7F);
    EXPECT_EQ(site_words(folder.path()).map(words), school.map()(words));
    ASSERT_TRUE(school.map_before());
    EXPECT_EQ((*school.map_before())(words), breeding::default_word_map()(words));
    const auto first = school.map()(words);
    ASSERT_TRUE(learn(school, sensible_answers(40)));
    EXPECT_EQ((*school.map_before())(words), first);
    EXPECT_FALSE(learn(school, sensible_answers(40))) << "nothing new was said";
}

TEST(School, KeepsItsMapWhenAnswersWouldMakeItWorseAndSaysSo) {
    const tests::TemporaryFolder folder;
    School school(folder.path());
    auto nonsense = sensible_answers(60);
    for (std::size_t i = 0; i < nonsense.readable.size(); ++i) {
        genome::WordAnswer& answer = nonsense.readable[i];
        for (const genome::ParameterId id : parameters_of(Aspect::Land, genome::Genome::Full))
            answer.scene.values.set(id, i % 2 == 0 ? parameter(id).min : parameter(id).max);
    }
    testing::internal::CaptureStderr();
    EXPECT_FALSE(learn(school, nonsense));
    EXPECT_EQ(school.map(), breeding::default_word_map());
    EXPECT_FALSE(std::filesystem::exists(folder / "words.json"));
    const auto training =
        breeding::train({{}, breeding::lessons_from(nonsense.readable)}, {}, school.map(), breeding::Worse::Refuse);
    EXPECT_THAT(training.said, testing::Contains(testing::HasSubstr("land: told from the others")));
    testing::internal::GetCapturedStderr();
}

TEST(School, OpensWithTheDefaultMapWhenItsFileIsDamagedOrOfAnotherVersion) {
    for (const char* text : {"{", R"({"quadrat":"word map","version":7,"curator":[],"visitors":[]})",
                             R"({"quadrat":"described","version":1,"aspect":"land","scenes":[{"words":{"nice":1},)"
                             R"("parameters":{}}]})"}) {
        const tests::TemporaryFolder folder;
        folder.write("words.json", text);
        School school(folder.path());
        EXPECT_EQ(school.map(), breeding::default_word_map()) << text;
        EXPECT_TRUE(learn(school, sensible_answers(30))) << "and goes on learning";
    }
}

TEST(School, RemembersWhatItLearntWhenTheAnswersAreLost) {
    const tests::TemporaryFolder folder;
    School school(folder.path());
    ASSERT_TRUE(learn(school, sensible_answers(30)));
    EXPECT_FALSE(learn(school, {}));
    EXPECT_EQ(site_words(folder.path()).lessons.visitors.size(), 30U);
}

TEST(Night, ChangesAtThreeInTheMorning) {
    const archive::WallTime midnight{std::chrono::sys_days{std::chrono::year{2031} / 2 / 3}};
    EXPECT_EQ(night_of(midnight + 3h), night_of(midnight + 26h + 59min));
    EXPECT_EQ(night_of(midnight + 2h + 59min) + 1, night_of(midnight + 3h));
}

}  // namespace
}  // namespace quadrat::learning
