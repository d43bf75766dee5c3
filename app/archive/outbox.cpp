// SPDX-License-Identifier: Apache-2.0
#include "archive/outbox.hpp"

#include <fmt/format.h>

#include "archive/archive_schema.hpp"

namespace quadrat::archive {

std::optional<Outbox> Outbox::open(const std::filesystem::path& directory) {
    const std::filesystem::path file = directory / "quadrat.db";
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return std::nullopt;
    try {
        Connection connection(file);
        if (connection.integer("PRAGMA user_version") != schema_version()) return std::nullopt;
        return Outbox(std::move(connection));
    } catch (const SqliteError&) {
        return std::nullopt;
    }
}

std::vector<Archive::Message> Outbox::waiting(int most) const {
    std::vector<Archive::Message> messages;
    try {
        Statement rows = connection_.prepare("SELECT id, topic, payload FROM outbox ORDER BY id LIMIT ?");
        rows.bind(std::int64_t{most});
        while (rows.step()) messages.push_back({rows.integer(0), rows.text(1), rows.text(2)});
    } catch (const SqliteError&) {
        return {};
    }
    return messages;
}

Trouble Outbox::forget(std::int64_t up_to_id) {
    try {
        connection_.prepare("DELETE FROM outbox WHERE id<=?").bind(up_to_id).run();
        return std::nullopt;
    } catch (const SqliteError& error) {
        return fmt::format("cannot forget what was sent: {}", error.what());
    }
}

std::string told_of_visit(exhibit::Ending ending, int rounds, WallTime at) {
    constexpr const char* kNames[] = {"finished", "left", "stuck"};
    return fmt::format(R"({{"ended_ms":{},"ending":"{}","rounds":{}}})", at.time_since_epoch().count(),
                       kNames[static_cast<std::size_t>(ending)], rounds);
}

}  // namespace quadrat::archive
