// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <stdexcept>

#include "archive/sqlite.hpp"

namespace quadrat::archive {

// The file is readable as SQLite, and yet not ours or not whole.
class DamageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// Whole, it may be, and of a program that is newer than this one.
class NewerError : public DamageError {
  public:
    using DamageError::DamageError;
};

// Whether that is what a damaged file makes SQLite say; anything else is about the disk, the folder or another program.
bool is_damage(const SqliteError& error, const std::filesystem::path& file);

enum class Found { Nothing, Ours, Older };

bool holds_nothing(const Connection& connection);       // no table, and no version
bool is_of_this_version(const Connection& connection);  // the tables of this program; what is in them is not checked

// Makes the tables where there are none, and brings those of an older version to this one. Throws DamageError for a
// file that holds anything else than the tables of its version or fails SQLite's own check; SqliteError as SQLite does.
Found prepare_schema(Connection& connection);

// What prepare_schema() would throw, without a change to the file; else its version.
int check_schema(const Connection& connection);

int schema_version();  // that this program keeps

// Moves a file of ours to a version, 1 to schema_version(), so that an older program can go on with it; what that
// version has no table for is dropped. All or nothing. Returns the version it had. Throws as above.
int move_schema(Connection& connection, int to);

}  // namespace quadrat::archive
