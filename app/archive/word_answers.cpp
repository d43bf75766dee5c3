// SPDX-License-Identifier: Apache-2.0
#include "archive/word_answers.hpp"

#include <fmt/format.h>

#include "archive/archive_schema.hpp"
#include "archive/reading.hpp"
#include "archive/scene_rows.hpp"
#include "archive/state_file.hpp"
#include "base/error.hpp"
#include "genome/json_text.hpp"
#include "genome/words_json.hpp"

namespace quadrat::archive {
namespace {

// Throws InputError when the row is not whole.
genome::WordAnswer answer_from(const Statement& row, const genome::Recipe& scene, const std::string& words) {
    genome::WordAnswer answer;
    const auto word = genome::word_named(row.text(0));
    if (!word) throw base::InputError("there is no such word");
    answer.word = *word;
    const std::int64_t step = row.integer(1);
    if (step < 0 || step >= static_cast<std::int64_t>(genome::kAnswerSteps.size()))
        throw base::InputError("there is no such answer");
    answer.step = static_cast<std::size_t>(step);
    answer.scene = scene;
    if (!words.empty()) answer.made_of = genome::words_from(genome::parse_json(words, "words"), "words", "words");
    return answer;
}

}  // namespace

WordAnswers word_answers_of(const Connection& connection) {
    WordAnswers answers;
    Statement rows = connection.prepare("SELECT word, step, scene, made_of FROM word_answer ORDER BY id");
    const SceneRows scenes(connection);
    std::string scene, made_of;
    while (rows.step()) {
        // Without a scene: the same as before.
        if (!rows.text(2).empty()) {
            scene = rows.text(2);
            made_of = rows.text(3);
        }
        try {
            answers.readable.push_back(answer_from(rows, scenes.scene(scene), made_of));
        } catch (const base::InputError&) {
            ++answers.unreadable;
        }
    }
    return answers;
}

std::filesystem::path state_file_in(const std::filesystem::path& directory) {
    std::filesystem::path file = directory / kStateFile;
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        throw base::InputError(fmt::format("{}: there is no state file; name its folder with --state", file.string()));
    return file;
}

WordAnswers word_answers_in(const std::filesystem::path& directory) {
    const std::filesystem::path file = state_file_in(directory);
    return named_in_errors(file, [&] { return read_from(file, word_answers_of); });
}

std::vector<Generation> last_generations_in(const std::filesystem::path& directory) {
    const std::filesystem::path file = state_file_in(directory);
    return named_in_errors(file, [&] { return read_from(file, last_generations_of); });
}

std::optional<std::int64_t> open_visit_in(const std::filesystem::path& directory) {
    const std::filesystem::path file = state_file_in(directory);
    return named_in_errors(file, [&] { return read_from(file, open_visit_of); });
}

int forget_word_answers_in(const std::filesystem::path& directory) {
    const std::filesystem::path file = state_file_in(directory);
    return named_in_errors(file, [&] {
        Connection connection(file);
        prepare_schema(connection);
        connection.trust_file();
        Transaction transaction(connection);
        const auto count = connection.integer("SELECT count(*) FROM word_answer");
        connection.run("DELETE FROM word_answer");
        transaction.commit();
        return static_cast<int>(count);
    });
}

}  // namespace quadrat::archive
