// SPDX-License-Identifier: Apache-2.0
#include "breeding/words/lessons.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::WordId;
using testing::HasSubstr;

float& word_of(DescribedScene& scene, WordId id) { return scene.words[static_cast<std::size_t>(id)].emplace(); }

// What somebody says of scenes grown from random words, when `sees` tells them how far along a word a scene is.
template <typename Sees>
std::vector<genome::WordAnswer> answers_about(int scenes, WordId word, const Sees& sees) {
    std::vector<genome::WordAnswer> answers;
    base::RandomStream chance{base::Seed{11}};
    for (int i = 0; i < scenes; ++i) {
        genome::WordAnswer answer;
        answer.made_of.emplace();
        for (const genome::Word& each : genome::vocabulary()) answer.made_of->set(each.id, chance.between(-0.8F, 0.8F));
        answer.scene.values = default_word_map()(*answer.made_of);
        answer.scene.flight = base::Seed{static_cast<std::uint64_t>(i)};
        answer.word = word;
        const float seen = sees((*answer.made_of)[word], chance);
        for (std::size_t step = 0; step < genome::kAnswerSteps.size(); ++step)
            if (std::abs(genome::kAnswerSteps[step] - seen) < std::abs(genome::kAnswerSteps[answer.step] - seen))
                answer.step = step;
        answers.push_back(answer);
    }
    return answers;
}

TEST(Lessons, AnswersAboutOneSceneAreOneExampleOfEachAspect) {
    auto answers = answers_about(2, WordId::wet, [](float seen, auto&) { return seen; });
    genome::WordAnswer green = answers[0];
    green.word = WordId::green;
    green.step = 3;
    genome::WordAnswer misty = answers[1];
    misty.word = WordId::misty;
    misty.made_of.reset();
    const auto lessons = lessons_from(std::vector{answers[0], green, answers[1], misty});
    ASSERT_EQ(lessons.size(), 3U);
    EXPECT_EQ(lessons[0].aspect, Aspect::Land);
    EXPECT_EQ(lessons[0].words[static_cast<std::size_t>(WordId::wet)], answers[0].value());
    EXPECT_EQ(lessons[0].words[static_cast<std::size_t>(WordId::green)], 1);
    EXPECT_EQ(lessons[0].words[static_cast<std::size_t>(WordId::rugged)], (*answers[0].made_of)[WordId::rugged]);
    EXPECT_EQ(lessons[2].aspect, Aspect::Sky);
    EXPECT_EQ(lessons[2].words[static_cast<std::size_t>(WordId::cloudy)], std::nullopt) << "nobody said: free";
    for (const DescribedScene& lesson : lessons) {
        EXPECT_TRUE(lesson.name.empty()) << "it must not be offered as an archetype";
        EXPECT_LT(lesson.weight, 1);
    }
}

TEST(Lessons, ComeBackFromTheirTextAndFromAFileOfDescribedScenes) {
    Lessons lessons;
    lessons.curator = {archetypes(Aspect::Land)[2], archetypes(Aspect::Sky)[1]};
    lessons.visitors = lessons_from(answers_about(5, WordId::tall, [](float seen, auto&) { return seen; }));
    EXPECT_EQ(word_lessons_from(to_json(lessons), "again"), lessons);
    EXPECT_EQ(word_lessons_from(to_json(Lessons{}), "again"), Lessons{});
    const auto& sky = archetypes(Aspect::Sky);
    EXPECT_EQ(word_lessons_from(to_json(sky, Aspect::Sky), "mine").curator, sky);
}

TEST(Lessons, OfAnotherVersionAreRefusedInOneLine) {
    const auto message = [](std::string_view text) -> std::string {
        try {
            word_lessons_from(text, "words.json");
        } catch (const base::InputError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message(R"({"quadrat":"word map","version":2,"curator":[],"visitors":[]})"),
              "words.json: version is 2; this program reads word maps of version 1");
    EXPECT_THAT(message(R"({"quadrat":"word map","version":1,"curator":{},"visitors":[]})"),
                HasSubstr("curator should be a list"));
    EXPECT_THAT(message(R"({"quadrat":"word map","version":1,"curator":[3],"visitors":[]})"), HasSubstr("words.json"));
    EXPECT_THAT(message("{"), HasSubstr("words.json:1"));
}

TEST(Training, MovesAWordTowardWhatVisitorsCallIt) {
    // Everybody finds these lands wetter than we do.
    Lessons wanted;
    wanted.visitors =
        lessons_from(answers_about(60, WordId::wet, [](float seen, auto&) { return std::min(1.0F, seen + 0.7F); }));
    const Training training = train(wanted, {}, default_word_map(), Worse::Take);
    genome::Description dry;
    dry.set(WordId::wet, -0.2F);
    genome::Description wet;
    wet.set(WordId::wet, 0.5F);
    const auto id = *genome::parameter_named("land.sea_level");
    const float taught = training.map(wet)[id];
    EXPECT_LT(std::abs(taught - default_word_map()(dry)[id]),
              std::abs(default_word_map()(wet)[id] - default_word_map()(dry)[id]))
        << "what we called drier is now meant";
}

TEST(Training, TakesWhatAgreesAndSaysNothing) {
    Lessons wanted;
    wanted.visitors = lessons_from(answers_about(40, WordId::wet, [](float seen, auto&) { return seen; }));
    const Training training = train(wanted, {}, default_word_map(), Worse::Refuse);
    EXPECT_EQ(training.lessons, wanted);
    EXPECT_TRUE(training.said.empty()) << training.said.front();
    EXPECT_LE(training.map.leave_one_out(Aspect::Land), default_word_map().leave_one_out(Aspect::Land));
    EXPECT_EQ(training.map.leave_one_out(Aspect::Sky), default_word_map().leave_one_out(Aspect::Sky));
}

// Scenes that say one thing and show another: by chance, and of full weight.
std::vector<DescribedScene> nonsense(Aspect aspect, int count) {
    std::vector<DescribedScene> scenes;
    base::RandomStream chance{base::Seed{5}};
    for (int i = 0; i < count; ++i) {
        DescribedScene scene;
        scene.aspect = aspect;
        for (const genome::Word& word : genome::vocabulary(aspect)) word_of(scene, word.id) = chance.between(-1, 1);
        for (const auto id : parameters_of(aspect, genome::Genome::Full))
            scene.values.set(id, chance.below(2) == 0 ? parameter(id).min : parameter(id).max);
        scenes.push_back(scene);
    }
    return scenes;
}

TEST(Training, RefusesAnAspectThatWouldGetWorseAndSaysSo) {
    Lessons wanted;
    wanted.curator = nonsense(Aspect::Sky, 30);
    wanted.visitors = lessons_from(answers_about(40, WordId::wet, [](float seen, auto&) { return seen; }));
    const Training refused = train(wanted, {}, default_word_map(), Worse::Refuse);
    EXPECT_TRUE(refused.lessons.curator.empty());
    EXPECT_EQ(refused.lessons.visitors, wanted.visitors) << "the other aspects learn";
    EXPECT_THAT(refused.said, testing::Contains(testing::AllOf(HasSubstr("sky: "), HasSubstr("its map stays"))));
    EXPECT_EQ(refused.map.leave_one_out(Aspect::Sky), default_word_map().leave_one_out(Aspect::Sky));
    const Training taken = train(wanted, {}, default_word_map(), Worse::Take);
    EXPECT_EQ(taken.lessons, wanted);
    EXPECT_THAT(taken.said, testing::Contains(HasSubstr("taken all the same")));
}

TEST(Training, WithNothingWantedGoesBackToTheDefaultMap) {
    Lessons before;
    before.curator = nonsense(Aspect::Sky, 10);
    const Training training = train({}, before, map_of(before), Worse::Refuse);
    EXPECT_EQ(training.map, default_word_map());
}

TEST(Remarks, NameScenesDescribedAlikeThatDiffer) {
    auto scenes = archetypes(Aspect::Land);
    EXPECT_TRUE(remarks_on(scenes).size() <= 2) << "only that trees and sky have no scenes";
    scenes[3].words = scenes[0].words;
    EXPECT_THAT(remarks_on(scenes),
                testing::Contains(testing::AllOf(HasSubstr("land: described alike and yet different"),
                                                 HasSubstr(scenes[0].name), HasSubstr(scenes[3].name))));
    scenes[3].values = scenes[0].values;
    EXPECT_THAT(remarks_on(scenes), testing::Not(testing::Contains(HasSubstr("alike and yet different"))));
}

TEST(Remarks, SayThatThereAreFewerScenesThanWords) {
    const auto& land = archetypes(Aspect::Land);
    EXPECT_THAT(remarks_on(std::vector{land[0], land[1]}),
                testing::Contains(HasSubstr("land: 2 described scenes for 8 words")));
}

TEST(Remarks, SayWhichScenesAreASingularSystem) {
    auto scenes = archetypes(Aspect::Land);
    for (DescribedScene& scene : scenes) {
        word_of(scene, WordId::wet) = 0.5F;
        word_of(scene, WordId::green) = scene.words[static_cast<std::size_t>(WordId::rugged)].value_or(0);
    }
    EXPECT_THAT(remarks_on(scenes), testing::Contains(HasSubstr("land: the scenes move 6 of 8 words independently")));
    const WordMap map(scenes);  // and the map stands it
    for (const DescribedScene& scene : scenes)
        for (const auto id : parameters_of(Aspect::Land, genome::Genome::Full))
            EXPECT_TRUE(std::isfinite(map(map.completed(scene.words))[id]));
}

TEST(Remarks, HaveNothingToSayOfTheDefaultScenes) { EXPECT_THAT(remarks_on(default_scenes()), testing::IsEmpty()); }

}  // namespace
}  // namespace quadrat::breeding
