// SPDX-License-Identifier: Apache-2.0
#include "exhibit/archive_schema.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

namespace quadrat::exhibit {
namespace {

constexpr std::int64_t kApplication = 0x51445254;  // "QDRT"
constexpr int kVersion = 3;

// Times are milliseconds since 1970, UTC. Seeds are text: SQLite's integers are signed.
constexpr const char* kTables = R"(
CREATE TABLE visit(id INTEGER PRIMARY KEY, began_ms INTEGER NOT NULL, ended_ms INTEGER, ending TEXT, rounds INTEGER);
CREATE TABLE answer(visit INTEGER NOT NULL, round INTEGER NOT NULL, aspect TEXT NOT NULL, candidate INTEGER NOT NULL, at_ms INTEGER NOT NULL, PRIMARY KEY(visit, round, aspect)) WITHOUT ROWID;
CREATE TABLE generation(id INTEGER PRIMARY KEY AUTOINCREMENT, visit INTEGER NOT NULL, round INTEGER NOT NULL, seed TEXT NOT NULL, flight TEXT NOT NULL, breeder TEXT NOT NULL, belief TEXT NOT NULL, offer TEXT NOT NULL, answers TEXT NOT NULL);
CREATE TABLE start(id INTEGER PRIMARY KEY AUTOINCREMENT, at_ms INTEGER NOT NULL);
)";

// From a version to the next, and back. A step that is here is never changed: files of every version are out there.
struct Migration {
    const char* up;
    const char* down;
};
constexpr std::array<Migration, kVersion - 1> kMigrations{{
    // A word, one of four answers, the scene it was said of, and the words that was grown from ("" for none).
    {R"(
CREATE TABLE word_answer(id INTEGER PRIMARY KEY AUTOINCREMENT, at_ms INTEGER NOT NULL, word TEXT NOT NULL, step INTEGER NOT NULL, scene TEXT NOT NULL, made_of TEXT NOT NULL);
)",
     "DROP TABLE word_answer"},
    {R"(
CREATE TABLE memory(name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE outbox(id INTEGER PRIMARY KEY AUTOINCREMENT, topic TEXT NOT NULL, payload TEXT NOT NULL);
)",
     "DROP TABLE memory; DROP TABLE outbox"},
}};

std::string schema_of(const Connection& connection) {
    std::string schema;
    Statement rows = connection.prepare("SELECT type, name, tbl_name, sql FROM sqlite_schema ORDER BY name");
    while (rows.step()) schema += fmt::format("{}|{}|{}|{}\n", rows.text(0), rows.text(1), rows.text(2), rows.text(3));
    return schema;
}

// The tables of a version, as SQLite lists them.
const std::string& schema_of_version(int version) {
    static const std::array<std::string, kVersion> schemas = [] {
        std::array<std::string, kVersion> all;
        Connection pattern(":memory:");
        pattern.run(kTables);
        all[0] = schema_of(pattern);
        for (std::size_t i = 0; i < kMigrations.size(); ++i) {
            pattern.run(kMigrations[i].up);
            all[i + 1] = schema_of(pattern);
        }
        return all;
    }();
    return schemas[static_cast<std::size_t>(version - 1)];
}

void set_version(Connection& connection, int version) {
    connection.run(fmt::format("PRAGMA user_version={}", version).c_str());
}

void create(Connection& connection) {
    // One transaction with its version: a kill in the middle leaves an empty file, which is a fresh one.
    Transaction transaction(connection);
    connection.run(kTables);
    for (const Migration& migration : kMigrations) connection.run(migration.up);
    connection.run(fmt::format("PRAGMA application_id={}", kApplication).c_str());
    set_version(connection, kVersion);
    transaction.commit();
}

int version_of_ours(const Connection& connection, const std::string& schema) {
    const std::int64_t application = connection.integer("PRAGMA application_id");
    if (application != kApplication) throw DamageError("it is not a state file of Quadrat");
    const std::int64_t version = connection.integer("PRAGMA user_version");
    if (version < 1 || version > kVersion)
        throw DamageError(
            fmt::format("its schema version is {}; this program keeps versions 1 to {}", version, kVersion));
    if (schema != schema_of_version(static_cast<int>(version)))
        throw DamageError("its tables are not those of its version");
    return static_cast<int>(version);
}

void require_whole(const Connection& connection) {
    Statement check = connection.prepare("PRAGMA quick_check(1)");
    if (!check.step() || check.text(0) != "ok") throw DamageError("it fails SQLite's check: " + check.text(0));
}

}  // namespace

Found prepare_schema(Connection& connection) {
    const std::string schema = schema_of(connection);
    const bool is_empty = schema.empty() && connection.integer("PRAGMA user_version") == 0;
    const int version = is_empty ? 0 : version_of_ours(connection, schema);
    if (is_empty) connection.run("PRAGMA auto_vacuum=INCREMENTAL");
    connection.run("PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL");
    if (is_empty) {
        create(connection);
        return Found::Nothing;
    }
    require_whole(connection);
    move_schema(connection, kVersion);
    return version == kVersion ? Found::Ours : Found::Older;
}

int schema_version() { return kVersion; }

int move_schema(Connection& connection, int to) {
    const int from = version_of_ours(connection, schema_of(connection));
    if (from == to) return from;
    // One transaction with its version: after a kill in the middle the file is as it was.
    Transaction transaction(connection);
    for (int version = from; version < to; ++version)
        connection.run(kMigrations[static_cast<std::size_t>(version - 1)].up);
    for (int version = from; version > to; --version)
        connection.run(kMigrations[static_cast<std::size_t>(version - 2)].down);
    set_version(connection, to);
    transaction.commit();
    return from;
}

}  // namespace quadrat::exhibit
