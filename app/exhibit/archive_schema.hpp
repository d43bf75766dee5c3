// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdexcept>

#include "exhibit/sqlite.hpp"

namespace quadrat::exhibit {

// The file is readable as SQLite, and yet not ours or not whole.
class DamageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

enum class Found { Nothing, Ours, Older };

bool holds_nothing(const Connection& connection);       // no table, and no version
bool is_of_this_version(const Connection& connection);  // the tables of this program; what is in them is not checked

// Makes the tables where there are none, and brings those of an older version to this one. Throws DamageError for a
// file that holds anything else than the tables of its version or fails SQLite's own check; SqliteError as SQLite does.
Found prepare_schema(Connection& connection);

int schema_version();  // that this program keeps

// Moves a file of ours to a version, 1 to schema_version(), so that an older program can go on with it; what that
// version has no table for is dropped. All or nothing. Returns the version it had. Throws as above.
int move_schema(Connection& connection, int to);

}  // namespace quadrat::exhibit
