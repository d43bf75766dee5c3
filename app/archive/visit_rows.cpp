// SPDX-License-Identifier: Apache-2.0
#include "archive/visit_rows.hpp"

#include "archive/reading.hpp"

namespace quadrat::archive {
namespace {

// The generations of one visit after the other. They were written in the order of their visits.
class Rounds {
  public:
    explicit Rounds(const Connection& connection, std::int64_t first_visit)
        : rows_(connection.prepare(
              "SELECT visit, round, ifnull(trees,-1), ifnull(land,-1), ifnull(sky,-1),"
              " ifnull(trees_ms,0), ifnull(land_ms,0), ifnull(sky_ms,0), breeder='chance' FROM generation"
              " WHERE id>=ifnull((SELECT id FROM generation WHERE visit>=? ORDER BY id LIMIT 1), 0)"
              " ORDER BY id")) {
        rows_.bind(first_visit);
        is_row_ = rows_.step();
    }

    void take(std::int64_t visit, VisitRow& of) {
        std::vector<RoundRow>& to = of.rounds;
        to.clear();
        of.is_by_chance = false;
        for (; is_row_ && rows_.integer(0) <= visit; is_row_ = rows_.step()) {
            if (rows_.integer(0) < visit) continue;
            of.is_by_chance = of.is_by_chance || rows_.integer(8) == 1;
            RoundRow row;
            row.round = static_cast<int>(rows_.integer(1));
            for (std::size_t i = 0; i < row.picked.size(); ++i) {
                row.picked[i] = static_cast<int>(rows_.integer(2 + static_cast<int>(i)));
                row.answered_ms[i] = rows_.integer(5 + static_cast<int>(i));
            }
            // A round that comes again was taken back, with all that came after it.
            while (!to.empty() && to.back().round >= row.round) to.pop_back();
            to.push_back(row);
        }
    }

  private:
    Statement rows_;
    bool is_row_ = false;
};

}  // namespace

void each_visit(const Connection& connection, std::int64_t from_ms, std::int64_t until_ms,
                const std::function<void(const VisitRow&)>& hear) {
    Statement visits = connection.prepare(
        "SELECT id, began_ms, ifnull(ended_ms,0), ending FROM visit WHERE began_ms>=? AND began_ms<? ORDER BY id");
    visits.bind(from_ms).bind(until_ms);
    if (!visits.step()) return;
    VisitRow row;
    Rounds rounds(connection, visits.integer(0));
    do {
        row.id = visits.integer(0);
        row.began_ms = visits.integer(1);
        row.ended_ms = visits.integer(2);
        row.ending = visits.text(3);
        rounds.take(row.id, row);
        hear(row);
    } while (visits.step());
}

std::vector<WordRow> word_rows(const Connection& connection, std::int64_t from_ms, std::int64_t until_ms) {
    std::vector<WordRow> words;
    Statement rows =
        connection.prepare("SELECT at_ms, word, step FROM word_answer WHERE at_ms>=? AND at_ms<? ORDER BY id");
    rows.bind(from_ms).bind(until_ms);
    while (rows.step()) words.push_back({rows.integer(0), rows.text(1), static_cast<int>(rows.integer(2))});
    return words;
}

std::vector<std::int64_t> starts(const Connection& connection, std::int64_t from_ms, std::int64_t until_ms) {
    std::vector<std::int64_t> starts;
    Statement rows = connection.prepare("SELECT at_ms FROM start WHERE at_ms>=? AND at_ms<? ORDER BY id");
    rows.bind(from_ms).bind(until_ms);
    while (rows.step()) starts.push_back(rows.integer(0));
    return starts;
}

std::string remembered(const Connection& connection, std::string_view name) {
    try {
        Statement row = connection.prepare("SELECT value FROM memory WHERE name=?");
        return row.bind(name).step() ? row.text(0) : std::string{};
    } catch (const SqliteError&) {
        return {};
    }
}

void read_state(const std::filesystem::path& directory, const std::function<void(const Connection&)>& read) {
    const std::filesystem::path file = state_file_in(directory);
    named_in_errors(file, [&] { read_from(file, read); });
}

}  // namespace quadrat::archive
