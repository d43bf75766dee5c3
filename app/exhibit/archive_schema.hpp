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

enum class Found { Nothing, Ours };

// Makes the tables where there are none. Throws DamageError for a file that holds anything else than the tables of this
// version or fails SQLite's own check; SqliteError as SQLite does.
Found prepare_schema(Connection& connection);

}  // namespace quadrat::exhibit
