// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <fmt/format.h>

#include <filesystem>

#include "archive/archive_schema.hpp"
#include "archive/state_file.hpp"
#include "base/error.hpp"

// What tools that run beside the exhibit read of a state file, without a change to it.
namespace quadrat::archive {

// Throws InputError where there is none.
std::filesystem::path state_file_in(const std::filesystem::path& directory);

// What is wrong with the file, as one InputError that names it.
template <typename Work>
auto named_in_errors(const std::filesystem::path& file, const Work& work) {
    try {
        return work();
    } catch (const SqliteError& error) {
        throw base::InputError(fmt::format("{}: {}", file.string(), error.what()));
    } catch (const DamageError& error) {
        throw base::InputError(
            fmt::format("{}: {}; the exhibit sets it aside at its next start", file.string(), error.what()));
    }
}

// read(connection) with the tables of this program: those of a file of an older one are brought up to date in memory.
template <typename Read>
auto read_from(const std::filesystem::path& file, const Read& read) {
    Connection connection = open_to_read(file);
    if (check_schema(connection) == schema_version()) return read(connection);
    Connection copy(":memory:");
    copy.run(fmt::format("PRAGMA page_size={}", connection.integer("PRAGMA page_size")).c_str());
    connection.copy_to(copy);
    move_schema(copy, schema_version());
    return read(copy);
}

}  // namespace quadrat::archive
