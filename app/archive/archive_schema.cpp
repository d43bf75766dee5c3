// SPDX-License-Identifier: Apache-2.0
#include "archive/archive_schema.hpp"

#include <fmt/format.h>
#include <sqlite3.h>
#include <unistd.h>

#include <array>
#include <string>

namespace quadrat::archive {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kApplication = 0x51445254;  // "QDRT"
constexpr int kVersion = 4;
// What is written is written in whole pages, to the log and to the file; most calls change a row of 100 bytes.
constexpr std::int64_t kPage_bytes = 512;

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
    // A generation by what it came from instead of all that it is, and in the same row what was answered, each when it
    // was given: a hundredth of what was written. Generations of before cannot be told so, nor those of since in the
    // old way: a visit that was interrupted then is not taken up. And a word answer without a scene is of the same one
    // as the answer before; one with a legend has its numbers there and their names in the legend.
    {R"(
DROP TABLE generation;
CREATE TABLE generation(id INTEGER PRIMARY KEY, visit INTEGER NOT NULL, round INTEGER NOT NULL, seed INTEGER, breeder TEXT, deeds TEXT, digest INTEGER, trees INTEGER, land INTEGER, sky INTEGER, trees_ms INTEGER, land_ms INTEGER, sky_ms INTEGER);
INSERT INTO generation(visit, round, trees, land, sky, trees_ms, land_ms, sky_ms)
SELECT visit, round, max(CASE aspect WHEN 'trees' THEN candidate END), max(CASE aspect WHEN 'land' THEN candidate END), max(CASE aspect WHEN 'sky' THEN candidate END), max(CASE aspect WHEN 'trees' THEN at_ms END), max(CASE aspect WHEN 'land' THEN at_ms END), max(CASE aspect WHEN 'sky' THEN at_ms END) FROM answer GROUP BY visit, round ORDER BY visit, round;
DROP TABLE answer;
CREATE TABLE legend(id INTEGER PRIMARY KEY, names TEXT NOT NULL UNIQUE);
)",
     R"(
UPDATE word_answer SET (scene, made_of)=(SELECT w.scene, w.made_of FROM word_answer w WHERE w.id<word_answer.id AND w.scene<>'' ORDER BY w.id DESC LIMIT 1) WHERE scene='' AND id>(SELECT min(id) FROM word_answer WHERE scene<>'');
DELETE FROM word_answer WHERE scene='';
UPDATE word_answer SET scene='{"quadrat":"scene","version":1,"seeds":' || json_extract(scene, '$.seeds') || ',"camera":"' || json_extract(scene, '$.camera') || '","parameters":' || (SELECT json_group_object(name.value, number.value) FROM legend, json_each(legend.names) name JOIN json_each(word_answer.scene, '$.values') number ON number.key=name.key WHERE legend.id=json_extract(word_answer.scene, '$.legend')) || '}' WHERE json_valid(scene) AND json_extract(scene, '$.legend') IN (SELECT id FROM legend);
DROP TABLE legend;
CREATE TABLE answer(visit INTEGER NOT NULL, round INTEGER NOT NULL, aspect TEXT NOT NULL, candidate INTEGER NOT NULL, at_ms INTEGER NOT NULL, PRIMARY KEY(visit, round, aspect)) WITHOUT ROWID;
INSERT OR REPLACE INTO answer SELECT visit, round, 'trees', trees, ifnull(trees_ms, 0) FROM generation WHERE trees IS NOT NULL ORDER BY id;
INSERT OR REPLACE INTO answer SELECT visit, round, 'land', land, ifnull(land_ms, 0) FROM generation WHERE land IS NOT NULL ORDER BY id;
INSERT OR REPLACE INTO answer SELECT visit, round, 'sky', sky, ifnull(sky_ms, 0) FROM generation WHERE sky IS NOT NULL ORDER BY id;
DROP TABLE generation;
CREATE TABLE generation(id INTEGER PRIMARY KEY AUTOINCREMENT, visit INTEGER NOT NULL, round INTEGER NOT NULL, seed TEXT NOT NULL, flight TEXT NOT NULL, breeder TEXT NOT NULL, belief TEXT NOT NULL, offer TEXT NOT NULL, answers TEXT NOT NULL);
)"},
}};

bool may_be_written(const fs::path& file) {
    return ::access(file.c_str(), W_OK) == 0 && ::access(file.parent_path().c_str(), W_OK) == 0;
}

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
    const std::string words =
        fmt::format("its schema version is {}; this program keeps versions 1 to {}", version, kVersion);
    if (version > kVersion) throw NewerError(words);
    if (version < 1) throw DamageError(words);
    if (schema != schema_of_version(static_cast<int>(version)))
        throw DamageError("its tables are not those of its version");
    return static_cast<int>(version);
}

void require_whole(const Connection& connection) {
    Statement check = connection.prepare("PRAGMA quick_check(1)");
    if (!check.step() || check.text(0) != "ok") throw DamageError("it fails SQLite's check: " + legible(check.text(0)));
}

// A file of an older program has larger pages. Not while somebody else reads it: then at the next start.
void use_small_pages(Connection& connection) {
    if (connection.integer("PRAGMA page_size") == kPage_bytes) return;
    try {
        connection.run("PRAGMA journal_mode=DELETE");
        connection.run(fmt::format("PRAGMA page_size={}; VACUUM", kPage_bytes).c_str());
    } catch (const SqliteError& error) {
        if (error.code() != SQLITE_BUSY && error.code() != SQLITE_LOCKED && error.code() != SQLITE_FULL) throw;
    }
    connection.run("PRAGMA journal_mode=WAL");
}

}  // namespace

bool is_damage(const SqliteError& error, const fs::path& file) {
    switch (error.code()) {
        case SQLITE_ERROR:
        case SQLITE_CORRUPT:
        case SQLITE_NOTADB:
        case SQLITE_FORMAT:
        case SQLITE_SCHEMA:
        case SQLITE_MISMATCH:
        case SQLITE_CONSTRAINT:
        case SQLITE_TOOBIG:
        case SQLITE_INTERNAL:
        case SQLITE_NOMEM:  // for a length that cannot be; where memory is short, nobody is told so
            return true;
        case SQLITE_READONLY:  // also of a file whose head says that a later SQLite wrote it
            return may_be_written(file);
        default:
            return false;
    }
}

bool holds_nothing(const Connection& connection) {
    return schema_of(connection).empty() && connection.integer("PRAGMA user_version") == 0;
}

bool is_of_this_version(const Connection& connection) {
    return connection.integer("PRAGMA application_id") == kApplication &&
           connection.integer("PRAGMA user_version") == kVersion &&
           schema_of(connection) == schema_of_version(kVersion);
}

Found prepare_schema(Connection& connection) {
    const std::string schema = schema_of(connection);
    const bool is_empty = holds_nothing(connection);
    const int version = is_empty ? 0 : version_of_ours(connection, schema);
    if (is_empty)
        connection.run(fmt::format("PRAGMA page_size={}; PRAGMA auto_vacuum=INCREMENTAL", kPage_bytes).c_str());
    connection.run("PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL");
    if (is_empty) {
        create(connection);
        return Found::Nothing;
    }
    require_whole(connection);
    move_schema(connection, kVersion);
    use_small_pages(connection);
    return version == kVersion ? Found::Ours : Found::Older;
}

int check_schema(const Connection& connection) {
    const int version = version_of_ours(connection, schema_of(connection));
    require_whole(connection);
    return version;
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

}  // namespace quadrat::archive
