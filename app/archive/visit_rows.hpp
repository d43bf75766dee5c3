// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "archive/sqlite.hpp"

// What visitors did, row by row, for whoever counts it. Beside a running exhibit, and without a change to the file.
namespace quadrat::archive {

// One round as it ended. Aspects are in the order of genome::kAspects.
struct RoundRow {
    int round = 1;
    std::array<int, 3> picked{-1, -1, -1};      // 0 to 3: A to D; -1 where nothing was answered
    std::array<std::int64_t, 3> answered_ms{};  // milliseconds since 1970; 0 where it is not known
    friend bool operator==(const RoundRow&, const RoundRow&) = default;
};

struct VisitRow {
    std::int64_t id = 0;
    std::int64_t began_ms = 0;
    std::int64_t ended_ms = 0;     // 0 for a visit that has not ended
    std::string ending;            // "finished", "left", "stuck"; "" for one that has not ended
    bool is_by_chance = false;     // the breeder that learns nothing bred it; known as long as its rounds are
    std::vector<RoundRow> rounds;  // as they stood in the end: one that was taken back and answered again is there once
};

// Visits that began in [from_ms, until_ms), oldest first. `rounds` are those of the visits whose generations are still
// kept. The row that `hear` gets is overwritten by the next. Throws SqliteError.
void each_visit(const Connection& connection, std::int64_t from_ms, std::int64_t until_ms,
                const std::function<void(const VisitRow&)>& hear);

struct WordRow {
    std::int64_t at_ms = 0;
    std::string word;  // its name; words of another program are among them
    int step = 0;      // of genome::kAnswerSteps
};
std::vector<WordRow> word_rows(const Connection& connection, std::int64_t from_ms, std::int64_t until_ms);

// When the exhibit was started. Oldest first.
std::vector<std::int64_t> starts(const Connection& connection, std::int64_t from_ms, std::int64_t until_ms);

// What is remembered under a name; "" where there is none.
std::string remembered(const Connection& connection, std::string_view name);

// read(connection) of the state file of a directory. Throws InputError: there is none, or it is not whole.
void read_state(const std::filesystem::path& directory, const std::function<void(const Connection&)>& read);

}  // namespace quadrat::archive
