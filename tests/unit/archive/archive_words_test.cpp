// SPDX-License-Identifier: Apache-2.0
// What visitors say of landscapes, kept to train the word map.
#include <gmock/gmock.h>

#include "archive/word_answers.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "genome/parameter_table.hpp"
#include "unit/archive/archive_fixture.hpp"

namespace quadrat::archive {
namespace {

genome::WordAnswer answer_of(std::uint64_t seed) {
    genome::WordAnswer answer;
    answer.scene = genome::random_recipe(base::Seed{seed});
    answer.word = seed % 2 == 0 ? genome::WordId::wet : genome::WordId::tall;
    answer.step = seed % 4;
    if (seed % 3 == 0) {
        answer.made_of.emplace();
        answer.made_of->set(genome::WordId::misty, 0.25F);
    }
    return answer;
}

TEST_F(ArchiveOnDisk, GivesBackWhatWasSaidOfLandscapesInOrder) {
    std::vector<genome::WordAnswer> said;
    {
        Archive archive = open().archive;
        EXPECT_TRUE(archive.word_answers().readable.empty());
        for (std::uint64_t i = 0; i < 6; ++i) {
            said.push_back(answer_of(i));
            EXPECT_EQ(archive.keep_word(said.back(), kNow), std::nullopt);
        }
    }
    EXPECT_EQ(open().archive.word_answers().readable, said);
    EXPECT_EQ(word_answers_in(directory_).readable, said) << "and to tools beside the exhibit";
}

TEST_F(ArchiveOnDisk, KeepsSceneWordAnswerAndTimeAndNothingOfTheVisitor) {
    EXPECT_EQ(open().archive.keep_word(answer_of(3), kNow), std::nullopt);
    Connection connection(file());
    Statement columns = connection.prepare("SELECT group_concat(name) FROM pragma_table_info('word_answer')");
    ASSERT_TRUE(columns.step());
    EXPECT_EQ(columns.text(0), "id,at_ms,word,step,scene,made_of");
    EXPECT_EQ(connection.integer("SELECT at_ms FROM word_answer"), kNow.time_since_epoch().count());
}

TEST_F(ArchiveOnDisk, ForgetsTheOldestWordsFirst) {
    Archive archive = open({.word_answers = 3}).archive;
    for (std::uint64_t i = 0; i < 8; ++i) EXPECT_EQ(archive.keep_word(answer_of(i), kNow), std::nullopt);
    EXPECT_THAT(archive.word_answers().readable, testing::ElementsAre(answer_of(5), answer_of(6), answer_of(7)));
}

TEST_F(ArchiveOnDisk, WritesALandscapeOnceHoweverManyWordsAreSaidOfIt) {
    std::vector<genome::WordAnswer> said;
    {
        Archive archive = open({.word_answers = 5}).archive;
        for (std::uint64_t i = 0; i < 6; ++i) {
            said.push_back(answer_of(i / 3 * 3));
            said.back().step = i % 4;
            EXPECT_EQ(archive.keep_word(said.back(), kNow), std::nullopt);
        }
        EXPECT_EQ(Connection(file()).integer("SELECT count(*) FROM word_answer WHERE scene<>''"), 1);
        EXPECT_THAT(archive.word_answers().readable, testing::ElementsAre(said[3], said[4], said[5]))
            << "with a landscape goes what was said of it";
        EXPECT_EQ(archive.word_answers().unreadable, 0);
    }
    const auto parameters = static_cast<std::int64_t>(genome::parameter_table().size());
    EXPECT_LT(Connection(file()).integer("SELECT max(length(scene)) FROM word_answer"), 11 * parameters)
        << "numbers alone";
    move_state(directory_, 3);
    EXPECT_EQ(Connection(file()).integer("SELECT count(*) FROM word_answer WHERE scene<>''"), 3);
    EXPECT_THAT(open().archive.word_answers().readable, testing::ElementsAre(said[3], said[4], said[5]));
}

TEST_F(ArchiveOnDisk, CountsAnswersThatSpeakOfWhatThereIsNot) {
    Archive archive = open().archive;
    for (std::uint64_t i = 0; i < 4; ++i) EXPECT_EQ(archive.keep_word(answer_of(i), kNow), std::nullopt);
    Connection connection(file());
    connection.run("UPDATE word_answer SET word='nice' WHERE id=1; UPDATE word_answer SET step=4 WHERE id=2");
    connection.run("UPDATE word_answer SET scene='{\"quadrat\":' WHERE id=3");
    const WordAnswers answers = archive.word_answers();
    EXPECT_THAT(answers.readable, testing::ElementsAre(answer_of(3)));
    EXPECT_EQ(answers.unreadable, 3);
}

TEST_F(ArchiveOnDisk, AreForgottenWhenAsked) {
    EXPECT_EQ(open().archive.keep_word(answer_of(1), kNow), std::nullopt);
    EXPECT_EQ(forget_word_answers_in(directory_), 1);
    EXPECT_TRUE(open().archive.word_answers().readable.empty());
}

TEST_F(ArchiveOnDisk, OfThePreviousSchemaIsContinued) {
    {
        Archive archive = open().archive;
        const auto begun = archive.begin_visit(kNow);
        EXPECT_EQ(archive.append(generation_of(begun.visit, 1)), std::nullopt);
    }
    EXPECT_EQ(move_state(directory_, 1), state_version());
    Archive::Opened opened = open();
    EXPECT_EQ(opened.condition, Archive::Condition::Continued) << opened.message;
    EXPECT_TRUE(opened.archive.is_open(1));
    EXPECT_EQ(opened.archive.keep_word(answer_of(2), kNow), std::nullopt);
    EXPECT_EQ(open().archive.word_answers().readable.size(), 1U);
}

TEST_F(ArchiveOnDisk, ToolsSayInOneLineThatThereIsNoneOrThatItIsDamaged) {
    const auto message = [&]() -> std::string {
        try {
            word_answers_in(directory_);
        } catch (const base::InputError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(message(), testing::HasSubstr("there is no state file"));
    EXPECT_FALSE(std::filesystem::exists(file())) << "nor was one made";
    base::write_file(file(), std::string(5000, 'x'));
    EXPECT_THAT(message(), testing::HasSubstr("quadrat.db: "));
    EXPECT_EQ(base::read_file(file()), std::string(5000, 'x')) << "a tool sets nothing aside";
}

}  // namespace
}  // namespace quadrat::archive
