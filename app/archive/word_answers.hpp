// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "archive/archive.hpp"

namespace quadrat::archive {

// The answers in the state file of a directory, for tools that run beside the exhibit: nothing in it is changed. Throws
// InputError naming the file when there is none, or none that is whole.
WordAnswers word_answers_in(const std::filesystem::path& directory);

// As last_generations_of(), of the state file of a directory. Throws as above.
std::vector<Generation> last_generations_in(const std::filesystem::path& directory);

// As open_visit_of(), likewise.
std::optional<std::int64_t> open_visit_in(const std::filesystem::path& directory);

// Deletes all of them, while no exhibit uses the directory; how many there were. Throws as above.
int forget_word_answers_in(const std::filesystem::path& directory);

// Of a database that is open. Throws SqliteError.
WordAnswers word_answers_of(const Connection& connection);

}  // namespace quadrat::archive
