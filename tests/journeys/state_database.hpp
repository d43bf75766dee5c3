// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sqlite3.h>

#include <filesystem>
#include <string>

namespace quadrat::tests {

// What the exhibit keeps, looked at from outside while it may be running.
class Database {
  public:
    explicit Database(const std::filesystem::path& file) {
        sqlite3_open_v2(file.c_str(), &db_, SQLITE_OPEN_READONLY, nullptr);
    }
    ~Database() { sqlite3_close(db_); }
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;
    int number(const std::string& sql) {
        sqlite3_stmt* statement = nullptr;
        int value = -1;
        if (sqlite3_prepare_v2(db_, sql.c_str(), -1, &statement, nullptr) == SQLITE_OK &&
            sqlite3_step(statement) == SQLITE_ROW)
            value = sqlite3_column_int(statement, 0);
        sqlite3_finalize(statement);
        return value;
    }

  private:
    sqlite3* db_ = nullptr;
};

}  // namespace quadrat::tests
