// SPDX-License-Identifier: Apache-2.0
#include "archive/sqlite.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <string>

namespace quadrat::archive {
namespace {

constexpr int kBusyTimeout_ms = 2000;  // a report being read beside the running exhibit

[[noreturn]] void fail(sqlite3* database, int code) {
    throw SqliteError(code & 0xff, legible(database != nullptr ? sqlite3_errmsg(database) : sqlite3_errstr(code)));
}

// Every byte as a number: no name means anything else.
std::string uri_at_rest(const std::filesystem::path& file) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string uri = "file:";
    for (const char c : std::filesystem::absolute(file).string()) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '/')
            uri += c;
        else
            (uri += '%').append({kDigits[byte >> 4U], kDigits[byte & 15U]});
    }
    return uri + "?immutable=1";
}

}  // namespace

std::string legible(std::string message) {
    std::ranges::replace_if(
        message, [](char c) { return c < ' ' || c > '~'; }, '?');
    return message;
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

void Statement::check(int code) const {
    if (code != SQLITE_OK) fail(sqlite3_db_handle(statement_.get()), code);
}

Statement& Statement::bind(std::int64_t value) {
    check(sqlite3_bind_int64(statement_.get(), ++bound_, value));
    return *this;
}

Statement& Statement::bind(std::string_view text) {
    check(sqlite3_bind_text(statement_.get(), ++bound_, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT));
    return *this;
}

Statement& Statement::bind_nothing() {
    check(sqlite3_bind_null(statement_.get(), ++bound_));
    return *this;
}

bool Statement::step() {
    const int code = sqlite3_step(statement_.get());
    if (code != SQLITE_ROW && code != SQLITE_DONE) fail(sqlite3_db_handle(statement_.get()), code);
    return code == SQLITE_ROW;
}

void Statement::run() {
    while (step()) {
    }
}

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }

std::string Statement::text(int column) const {
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
    if (text == nullptr) return {};
    return {text, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))};
}

void Connection::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

Connection::Connection(const std::filesystem::path& file, Access access) {
    sqlite3* database = nullptr;
    const int flags =
        access == Access::ReadAndWrite ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READONLY;
    const int code = access == Access::ReadAtRest
                         ? sqlite3_open_v2(uri_at_rest(file).c_str(), &database, flags | SQLITE_OPEN_URI, nullptr)
                         : sqlite3_open_v2(file.c_str(), &database, flags, nullptr);
    database_.reset(database);
    if (code != SQLITE_OK) fail(database, code);
    sqlite3_busy_timeout(database, kBusyTimeout_ms);
    // The file may be damaged, and damage may look like a schema: nothing in it gets to run.
    sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
    run("PRAGMA cell_size_check=ON");
}

void Connection::trust_file() { sqlite3_db_config(database_.get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 0, nullptr); }

void Connection::run(const char* sql) {
    const int code = sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) fail(database_.get(), code);
}

Statement Connection::prepare(std::string_view sql) const {
    sqlite3_stmt* statement = nullptr;
    const int code = sqlite3_prepare_v2(database_.get(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
    if (code != SQLITE_OK) fail(database_.get(), code);
    return Statement(statement);
}

std::int64_t Connection::integer(std::string_view sql) const {
    Statement statement = prepare(sql);
    return statement.step() ? statement.integer(0) : 0;
}

std::int64_t Connection::last_row() const { return sqlite3_last_insert_rowid(database_.get()); }

bool Connection::is_in_transaction() const { return sqlite3_get_autocommit(database_.get()) == 0; }

void Connection::copy_to(Connection& other, const std::function<void(double share)>& copied) {
    constexpr int kPagesAtOnce = 1024;
    // While this is read from, what others write is seen by none of the steps: they copy one moment, and never begin
    // again.
    const bool is_part = is_in_transaction();
    if (!is_part) run("BEGIN");
    integer("SELECT count(*) FROM sqlite_schema");
    struct Finish {
        void operator()(sqlite3_backup* backup) const { sqlite3_backup_finish(backup); }
    };
    const std::unique_ptr<sqlite3_backup, Finish> backup(
        sqlite3_backup_init(other.database_.get(), "main", database_.get(), "main"));
    if (!backup) fail(other.database_.get(), sqlite3_errcode(other.database_.get()));
    int code = SQLITE_OK;
    while (code == SQLITE_OK) {
        code = sqlite3_backup_step(backup.get(), kPagesAtOnce);
        const int pages = sqlite3_backup_pagecount(backup.get());
        if (copied && pages > 0) copied(1.0 - static_cast<double>(sqlite3_backup_remaining(backup.get())) / pages);
    }
    if (code != SQLITE_DONE) fail(nullptr, code);
    if (!is_part) run("COMMIT");
}

Transaction::Transaction(Connection& connection) : connection_(connection), is_part_(connection.is_in_transaction()) {
    connection_.run(is_part_ ? "SAVEPOINT part" : "BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
    // Some errors have rolled back already; a rollback that fails leaves nothing that we could still undo.
    if (is_done_ || !connection_.is_in_transaction()) return;
    try {
        connection_.run(is_part_ ? "ROLLBACK TO part; RELEASE part" : "ROLLBACK");
    } catch (const SqliteError&) {
        return;
    }
}

void Transaction::commit() {
    connection_.run(is_part_ ? "RELEASE part" : "COMMIT");
    is_done_ = true;
}

}  // namespace quadrat::archive
