// SPDX-License-Identifier: Apache-2.0
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <system_error>
#include <utility>

#include "archive/archive.hpp"
#include "archive/archive_schema.hpp"
#include "base/error.hpp"

namespace quadrat::archive {
namespace {

namespace fs = std::filesystem;

std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

// A name that is free, and what will follow it for -wal and -shm.
fs::path name_aside(const fs::path& file, WallTime now) {
    const auto seconds = std::chrono::floor<std::chrono::seconds>(now);
    const std::string stamp =
        fmt::format("{:%Y%m%d-%H%M%S}", fmt::gmtime(std::chrono::system_clock::to_time_t(seconds)));
    const std::string name = fmt::format("{}.damaged-{}", file.string(), stamp);
    std::error_code ignored;
    if (!fs::exists(name, ignored)) return name;
    for (int i = 2;; ++i)
        if (fs::path next = fmt::format("{}-{}", name, i); !fs::exists(next, ignored)) return next;
}

std::error_code set_aside(const fs::path& file, const fs::path& aside) {
    std::error_code error;
    // The log first: a database without its log is older, a log without its database is nothing.
    for (const std::string_view part : {"-wal", "-shm", ""}) {
        const fs::path from = file.string() + std::string(part);
        std::error_code ignored;
        if (!part.empty() && !fs::exists(from, ignored)) continue;
        fs::rename(from, aside.string() + std::string(part), error);
        if (error) return error;
    }
    return error;
}

// Also tells that the file can be written: SQLite opens one that cannot, and says so only now.
void note_start(Connection& connection, WallTime now) {
    constexpr int kStarts = 10'000;
    Transaction transaction(connection);
    connection.prepare("INSERT INTO start(at_ms) VALUES(?)").bind(now.time_since_epoch().count()).run();
    connection.prepare("DELETE FROM start WHERE id<=?").bind(connection.last_row() - kStarts).run();
    transaction.commit();
}

// A damaged file says so as one exception, whichever layer noticed.
template <typename Open>
auto opened_or_damage(const fs::path& file, const Open& open) {
    try {
        return open();
    } catch (const SqliteError& error) {
        if (is_damage(error, file)) throw DamageError(error.what());
        throw;
    }
}

}  // namespace

Archive::Opened Archive::open_file(const fs::path& file, WallTime now, const Retention& retention,
                                   const TellKept& tell) {
    return opened_or_damage(file, [&] {
        Connection connection(file);
        const bool is_known = holds_nothing(connection) || is_of_this_version(connection);
        if (tell && is_known) tell(kept_in(connection));
        const Found found = prepare_schema(connection);
        Archive archive(std::move(connection), retention);
        require_whole(archive.connection_);
        if (tell && !is_known) tell(archive.kept());
        note_start(archive.connection_, now);
        archive.connection_.trust_file();
        constexpr std::array<const char*, 3> kWords{"a new state file", "the state file is whole",
                                                    "the state file of an older version was brought up to date"};
        return Opened{std::move(archive), found == Found::Nothing ? Condition::Fresh : Condition::Continued,
                      fmt::format("{}: {}", file.string(), kWords[static_cast<std::size_t>(found)])};
    });
}

Archive::Opened Archive::open_in_memory(const fs::path& file, std::string_view why, WallTime now,
                                        const Retention& retention, const TellKept& tell) {
    Opened opened = open_file(":memory:", now, retention, tell);
    opened.condition = Condition::MemoryOnly;
    opened.message = fmt::format("{}: {}; the state is kept in memory only and is lost at the end", file.string(), why);
    return opened;
}

Archive::Opened Archive::replace(const fs::path& file, std::string_view damage, WallTime now,
                                 const Retention& retention, const TellKept& tell) {
    const fs::path aside = name_aside(file, now);
    if (const auto failure = set_aside(file, aside)) {
        const std::string why = fmt::format("damaged ({}) and cannot be set aside ({})", damage, failure.message());
        return open_in_memory(file, why, now, retention, tell);
    }
    Opened opened = open_file(file, now, retention, tell);
    opened.condition = Condition::Replaced;
    opened.message = fmt::format("{}: damaged ({}); set aside as {}, and a fresh one begun", file.string(), damage,
                                 aside.filename().string());
    return opened;
}

Archive::Opened Archive::open(const fs::path& directory, WallTime now, const Retention& retention,
                              const TellKept& tell) {
    const fs::path file = directory / "quadrat.db";
    std::error_code ignored;  // opening the file says it better
    fs::create_directories(directory, ignored);
    try {
        try {
            return open_file(file, now, retention, tell);
        } catch (const DamageError& damage) {
            return replace(file, one_line(damage.what()), now, retention, tell);
        }
    } catch (const SqliteError& trouble) {
        return open_in_memory(file, one_line(trouble.what()), now, retention, tell);
    }
}

int move_state(const fs::path& directory, int version) {
    const fs::path file = directory / "quadrat.db";
    try {
        if (!fs::exists(file)) throw base::InputError(fmt::format("{}: there is no such file", file.string()));
        if (version < 1 || version > schema_version())
            throw base::InputError(fmt::format("version {}: there are 1 to {}", version, schema_version()));
        Connection connection(file);
        connection.trust_file();
        return move_schema(connection, version);
    } catch (const std::runtime_error& error) {
        if (dynamic_cast<const base::InputError*>(&error) != nullptr) throw;
        throw base::InputError(fmt::format("{}: {}", file.string(), one_line(error.what())));
    }
}

int state_version() { return schema_version(); }

}  // namespace quadrat::archive
