// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace quadrat::archive {

// What SQLite says of a damaged file quotes what that holds: no byte of it may reach a terminal.
std::string legible(std::string message);

// As much of SQLite as the archive needs. Both throw SqliteError; the archive turns it into a value.
class SqliteError : public std::runtime_error {
  public:
    SqliteError(int code, const std::string& message) : std::runtime_error(message), code_(code) {}
    int code() const { return code_; }  // SQLite's primary result code

  private:
    int code_;
};

class Statement {
  public:
    // The next parameter, from the left.
    Statement& bind(std::int64_t value);
    Statement& bind(std::string_view text);
    Statement& bind_nothing();  // NULL

    bool step();  // true: a row
    void run();   // to the end

    std::int64_t integer(int column) const;
    std::string text(int column) const;  // "" for NULL

  private:
    friend class Connection;
    struct Finalize {
        void operator()(sqlite3_stmt* statement) const;
    };

    explicit Statement(sqlite3_stmt* statement) : statement_(statement) {}
    void check(int code) const;

    std::unique_ptr<sqlite3_stmt, Finalize> statement_;
    int bound_ = 0;
};

enum class Access {
    ReadAndWrite,  // the file is created when it is not there
    Read,          // beside whoever writes
    ReadAtRest,    // nobody writes and there is no log beside it: nothing is made there either
};

class Connection {
  public:
    // ":memory:" is a database of its own.
    explicit Connection(const std::filesystem::path& file, Access access = Access::ReadAndWrite);

    void run(const char* sql);  // one statement or several, without results
    Statement prepare(std::string_view sql) const;
    std::int64_t integer(std::string_view sql) const;  // the first column of the first row; 0 without one
    std::int64_t last_row() const;
    bool is_in_transaction() const;

    // Puts this database, as it is at one moment, in place of all that is in the other; `copied` hears the share that
    // is done. Others may go on writing to this one.
    void copy_to(Connection& other, const std::function<void(double share)>& copied = {});

    // A connection leaves the log beside the file as it found it, since the file may turn out to be damaged. Once it is
    // known to be whole, closing may write the log into it.
    void trust_file();

  private:
    struct Close {
        void operator()(sqlite3* database) const;
    };
    std::unique_ptr<sqlite3, Close> database_;
};

// All or nothing: rolled back unless committed. Within another it is a part of that, and commits with it.
class Transaction {
  public:
    explicit Transaction(Connection& connection);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    void commit();

  private:
    Connection& connection_;
    bool is_part_;
    bool is_done_ = false;
};

}  // namespace quadrat::archive
