// SPDX-License-Identifier: Apache-2.0
#include "archive/state_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "archive/archive.hpp"
#include "archive/archive_schema.hpp"
#include "archive/state_lock.hpp"
#include "base/error.hpp"

namespace quadrat::archive {
namespace {

namespace fs = std::filesystem;

std::uintmax_t size_of(const fs::path& file) {
    std::error_code error;
    const auto size = fs::file_size(file, error);
    return error ? 0 : size;
}

fs::path log_of(const fs::path& file) { return file.string() + "-wal"; }

std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

void check(const fs::path& file, StateReport& report) {
    const Connection connection = open_to_read(file);
    if (holds_nothing(connection)) {
        report.condition = Condition::Missing;
        return;
    }
    report.version = check_schema(connection);
    if (report.version == schema_version()) {
        Archive::require_whole(connection);
        report.condition = Condition::Whole;
    } else {
        report.condition = Condition::Older;
        report.what = fmt::format("its tables are of version {}; this program's are of version {}", report.version,
                                  schema_version());
    }
}

StateReport examined(const fs::path& file) {
    StateReport report;
    std::error_code error;
    if (!fs::exists(file, error)) return report;
    report.file_bytes = size_of(file);
    report.log_bytes = size_of(log_of(file));
    const auto note = [&](Condition condition, const std::exception& why) {
        report.condition = condition;
        report.what = one_line(why.what());
    };
    try {
        check(file, report);
    } catch (const NewerError& newer) {
        note(Condition::Newer, newer);
    } catch (const DamageError& damage) {
        note(Condition::Damaged, damage);
    } catch (const SqliteError& trouble) {
        note(is_damage(trouble, file) ? Condition::Damaged : Condition::Unreadable, trouble);
    }
    return report;
}

// Runs work that SQLite may refuse; what it throws names the file.
template <typename Work>
void name_in_errors(const fs::path& file, const Work& work) {
    try {
        work();
    } catch (const SqliteError& error) {
        throw base::InputError(fmt::format("{}: {}", file.string(), one_line(error.what())));
    }
}

}  // namespace

StateReport examine_state_file(const fs::path& file) {
    StateReport report = examined(file);
    // An exhibit that has just begun may have written while the file was read as one at rest.
    if (report.condition == Condition::Damaged && holder_of(file.parent_path())) report = examined(file);
    return report;
}

Connection open_to_read(const fs::path& file) {
    // Where nobody writes, nothing is made beside the file, and a folder that is closed to us is no hindrance.
    const bool is_at_rest = size_of(log_of(file)) == 0 && !holder_of(file.parent_path());
    return Connection(file, is_at_rest ? Access::ReadAtRest : Access::Read);
}

void copy_state(const fs::path& directory, const fs::path& to, const std::function<void(double share)>& copied) {
    const fs::path file = directory / kStateFile;
    const StateReport report = examine_state_file(file);
    if (report.condition != Condition::Whole && report.condition != Condition::Older)
        throw base::InputError(fmt::format("{}: {}", file.string(),
                                           report.condition == Condition::Missing ? "there is no state" : report.what));
    name_in_errors(to, [&] {
        Connection copy(to);
        open_to_read(file).copy_to(copy, copied);
        copy.trust_file();
        copy.run("PRAGMA journal_mode=DELETE");
    });
    const StateReport made = examine_state_file(to);
    if (made.condition != report.condition)
        throw base::InputError(fmt::format("{}: the copy is not whole: {}", to.string(), made.what));
}

void forget_machine(const fs::path& file) {
    name_in_errors(file, [&] {
        Connection connection(file);
        connection.trust_file();
        prepare_schema(connection);
        Transaction transaction(connection);
        connection.run(
            "DELETE FROM visit; DELETE FROM generation; DELETE FROM start; DELETE FROM outbox;"
            "DELETE FROM memory WHERE name='buttons';"
            "DELETE FROM sqlite_sequence WHERE name IN ('visit', 'generation', 'start', 'outbox')");
        transaction.commit();
        connection.run("PRAGMA journal_mode=DELETE; VACUUM");
    });
}

}  // namespace quadrat::archive
