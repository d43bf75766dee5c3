// SPDX-License-Identifier: Apache-2.0
#include "exhibit/archive_schema.hpp"

#include <fmt/format.h>

#include <string>

namespace quadrat::exhibit {
namespace {

constexpr std::int64_t kApplication = 0x51445254;  // "QDRT"
constexpr std::int64_t kVersion = 1;

// Times are milliseconds since 1970, UTC. Seeds are text: SQLite's integers are signed.
constexpr const char* kTables = R"(
CREATE TABLE visit(id INTEGER PRIMARY KEY, began_ms INTEGER NOT NULL, ended_ms INTEGER, ending TEXT, rounds INTEGER);
CREATE TABLE answer(visit INTEGER NOT NULL, round INTEGER NOT NULL, aspect TEXT NOT NULL, candidate INTEGER NOT NULL, at_ms INTEGER NOT NULL, PRIMARY KEY(visit, round, aspect)) WITHOUT ROWID;
CREATE TABLE generation(id INTEGER PRIMARY KEY AUTOINCREMENT, visit INTEGER NOT NULL, round INTEGER NOT NULL, seed TEXT NOT NULL, flight TEXT NOT NULL, breeder TEXT NOT NULL, belief TEXT NOT NULL, offer TEXT NOT NULL, answers TEXT NOT NULL);
CREATE TABLE start(id INTEGER PRIMARY KEY AUTOINCREMENT, at_ms INTEGER NOT NULL);
)";

std::string schema_of(const Connection& connection) {
    std::string schema;
    Statement rows = connection.prepare("SELECT type, name, tbl_name, sql FROM sqlite_schema ORDER BY name");
    while (rows.step()) schema += fmt::format("{}|{}|{}|{}\n", rows.text(0), rows.text(1), rows.text(2), rows.text(3));
    return schema;
}

const std::string& our_schema() {
    static const std::string schema = [] {
        Connection pattern(":memory:");
        pattern.run(kTables);
        return schema_of(pattern);
    }();
    return schema;
}

void create(Connection& connection) {
    // One transaction with its version: a kill in the middle leaves an empty file, which is a fresh one.
    Transaction transaction(connection);
    connection.run(kTables);
    connection.run(fmt::format("PRAGMA application_id={}; PRAGMA user_version={}", kApplication, kVersion).c_str());
    transaction.commit();
}

void require_ours(const Connection& connection, const std::string& schema) {
    const std::int64_t application = connection.integer("PRAGMA application_id");
    if (application != kApplication) throw DamageError("it is not a state file of Quadrat");
    const std::int64_t version = connection.integer("PRAGMA user_version");
    if (version != kVersion)
        throw DamageError(fmt::format("its schema version is {}; this program keeps version {}", version, kVersion));
    if (schema != our_schema()) throw DamageError("its tables are not those of its version");
}

}  // namespace

Found prepare_schema(Connection& connection) {
    const std::string schema = schema_of(connection);
    const bool is_empty = schema.empty() && connection.integer("PRAGMA user_version") == 0;
    if (!is_empty) require_ours(connection, schema);
    if (is_empty) connection.run("PRAGMA auto_vacuum=INCREMENTAL");
    connection.run("PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL");
    if (is_empty) {
        create(connection);
        return Found::Nothing;
    }
    Statement check = connection.prepare("PRAGMA quick_check(1)");
    if (!check.step() || check.text(0) != "ok") throw DamageError("it fails SQLite's check: " + check.text(0));
    return Found::Ours;
}

}  // namespace quadrat::exhibit
