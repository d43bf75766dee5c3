// SPDX-License-Identifier: Apache-2.0
#include "exhibit/archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "exhibit/archive_schema.hpp"
#include "exhibit/word_answers.hpp"
#include "genome/json_text.hpp"
#include "genome/offer_json.hpp"
#include "genome/words_json.hpp"

namespace quadrat::exhibit {
namespace {

std::string_view name_of(Ending ending) {
    switch (ending) {
        case Ending::Finished:
            return "finished";
        case Ending::Left:
            return "left";
        case Ending::Stuck:
            return "stuck";
    }
    return "";
}

std::int64_t milliseconds_of(WallTime at) { return at.time_since_epoch().count(); }

base::Seed seed_from(const std::string& text) {
    const auto seed = genome::seed_of(text);
    if (!seed) throw base::InputError("a seed is not 16 hexadecimal digits");
    return *seed;
}

constexpr std::string_view kGenerations =
    "SELECT visit, round, seed, flight, breeder, belief, offer, answers FROM generation ORDER BY id DESC";
constexpr std::int64_t kSpare_pages = 256;
constexpr std::int64_t kLargestNumber = std::int64_t{1} << 53;  // of a visit or a row; leaves room to count on

// Throws InputError when the row is not whole.
Generation generation_from(const Statement& row) {
    Generation generation;
    generation.visit = row.integer(0);
    generation.seed = seed_from(row.text(2));
    generation.flight = seed_from(row.text(3));
    generation.breeder = row.text(4);
    generation.belief = row.text(5);
    genome::parse_json(generation.belief, "belief");
    generation.offer = genome::offer_from_json(row.text(6), "offer");
    generation.answers = genome::pick_from_json(row.text(7), "answers");
    if (generation.offer.round != row.integer(1)) throw base::InputError("the offer is of another round than its row");
    return generation;
}

// The rows of `answer` are what holds; a generation's own column is what it began with. So an answer writes a page, not
// the whole generation again.
genome::Pick answers_of(const Connection& connection, std::int64_t visit, int round) {
    genome::Pick answers;
    Statement rows = connection.prepare("SELECT aspect, candidate FROM answer WHERE visit=? AND round=?");
    rows.bind(visit).bind(round);
    while (rows.step()) {
        const std::string name = rows.text(0);
        const std::int64_t candidate = rows.integer(1);
        for (const genome::Aspect aspect : genome::kAspects)
            if (genome::name_of(aspect) == name && candidate >= 0 && candidate < std::int64_t{genome::kCandidates})
                answers[aspect] = static_cast<std::size_t>(candidate);
    }
    return answers;
}

void set_answers(Connection& connection, std::int64_t visit, int round, const genome::Pick& answers, WallTime at) {
    for (const genome::Aspect aspect : genome::kAspects) {
        if (!answers[aspect]) {
            connection.prepare("DELETE FROM answer WHERE visit=? AND round=? AND aspect=?")
                .bind(visit)
                .bind(round)
                .bind(genome::name_of(aspect))
                .run();
            continue;
        }
        // An answer that stands keeps its time.
        connection
            .prepare(
                "INSERT INTO answer VALUES(?,?,?,?,?) ON CONFLICT DO UPDATE SET candidate=excluded.candidate, "
                "at_ms=excluded.at_ms WHERE candidate<>excluded.candidate")
            .bind(visit)
            .bind(round)
            .bind(genome::name_of(aspect))
            .bind(static_cast<std::int64_t>(*answers[aspect]))
            .bind(milliseconds_of(at))
            .run();
    }
}

}  // namespace

Archive::Archive(Connection connection, const Retention& retention)
    : connection_(std::move(connection)),
      retention_(retention),
      last_visit_(connection_.integer("SELECT max(id) FROM visit")) {}

void Archive::require_whole() const {
    if (connection_.integer("SELECT min(id) FROM visit") < 0 || last_visit_ > kLargestNumber ||
        connection_.integer("SELECT max(seq) FROM sqlite_sequence") > kLargestNumber)
        throw DamageError("it holds numbers that were never written");
    try {
        Statement rows = connection_.prepare(kGenerations);
        if (rows.step()) generation_from(rows);
    } catch (const base::InputError& error) {
        throw DamageError(fmt::format("its last generation cannot be read: {}", error.what()));
    }
}

template <typename Work>
Trouble Archive::attempt(std::string_view what, const Work& work) {
    try {
        Transaction transaction(connection_);
        work();
        transaction.commit();
        return std::nullopt;
    } catch (const SqliteError& error) {
        return fmt::format("cannot keep {}: {}", what, error.what());
    }
}

Archive::Begun Archive::begin_visit(WallTime at) {
    const std::int64_t visit = ++last_visit_;
    Trouble trouble = attempt("the visit", [&] {
        connection_.prepare("INSERT INTO visit(id, began_ms) VALUES(?,?)").bind(visit).bind(milliseconds_of(at)).run();
        const std::int64_t oldest = visit - retention_.visits;
        connection_.prepare("DELETE FROM visit WHERE id<=?").bind(oldest).run();
        connection_.prepare("DELETE FROM answer WHERE visit<=?").bind(oldest).run();
    });
    return {visit, std::move(trouble)};
}

Trouble Archive::end_visit(std::int64_t visit, Ending ending, int rounds, WallTime at) {
    return attempt("the end of the visit", [&] {
        connection_.prepare("UPDATE visit SET ended_ms=?, ending=?, rounds=? WHERE id=?")
            .bind(milliseconds_of(at))
            .bind(name_of(ending))
            .bind(rounds)
            .bind(visit)
            .run();
    });
}

Trouble Archive::append(const Generation& generation) {
    Trouble trouble = attempt("the generation", [&] {
        connection_
            .prepare(
                "INSERT INTO generation(visit, round, seed, flight, breeder, belief, offer, answers) "
                "VALUES(?,?,?,?,?,?,?,?)")
            .bind(generation.visit)
            .bind(generation.offer.round)
            .bind(genome::text_of(generation.seed))
            .bind(genome::text_of(generation.flight))
            .bind(generation.breeder)
            .bind(generation.belief)
            .bind(genome::to_json(generation.offer))
            .bind(genome::to_json(generation.answers))
            .run();
        const std::int64_t oldest = connection_.last_row() - std::max(1, retention_.generations);
        set_answers(connection_, generation.visit, generation.offer.round, generation.answers, {});
        connection_.prepare("DELETE FROM generation WHERE id<=?").bind(oldest).run();
    });
    if (trouble) return trouble;
    try {
        // A few pages a time give back what was deleted, without a pause that anyone could notice. What the next
        // generations will fill again stays: pages that come and go wear a card out.
        if (connection_.integer("PRAGMA freelist_count") > kSpare_pages)
            connection_.prepare("PRAGMA incremental_vacuum(16)").run();
    } catch (const SqliteError& error) {
        return fmt::format("kept the generation, but cannot give back disk space: {}", error.what());
    }
    return std::nullopt;
}

Trouble Archive::keep_answers(std::int64_t visit, int round, const genome::Pick& answers, WallTime at) {
    return attempt("the answers", [&] {
        set_answers(connection_, visit, round, answers, at);
    });
}

Trouble Archive::keep_word(const genome::WordAnswer& answer, WallTime at) {
    return attempt("what was said of the landscape", [&] {
        connection_.prepare("INSERT INTO word_answer(at_ms, word, step, scene, made_of) VALUES(?,?,?,?,?)")
            .bind(milliseconds_of(at))
            .bind(word(answer.word).name)
            .bind(static_cast<std::int64_t>(answer.step))
            .bind(genome::to_json(answer.scene))
            .bind(answer.made_of ? genome::words_json(*answer.made_of) : "")
            .run();
        const std::int64_t oldest = connection_.last_row() - std::max(1, retention_.word_answers);
        connection_.prepare("DELETE FROM word_answer WHERE id<=?").bind(oldest).run();
    });
}

WordAnswers Archive::word_answers() const {
    try {
        return word_answers_of(connection_);
    } catch (const SqliteError&) {
        return {};
    }
}

Trouble Archive::remember(std::string_view name, std::string_view value) {
    return attempt(name, [&] {
        connection_.prepare("INSERT INTO memory VALUES(?,?) ON CONFLICT DO UPDATE SET value=excluded.value")
            .bind(name)
            .bind(value)
            .run();
    });
}

std::string Archive::remembered(std::string_view name) const {
    try {
        Statement row = connection_.prepare("SELECT value FROM memory WHERE name=?");
        return row.bind(name).step() ? row.text(0) : std::string{};
    } catch (const SqliteError&) {
        return {};
    }
}

Trouble Archive::post(std::string_view topic, std::string_view payload, int most) {
    return attempt("a message", [&] {
        connection_.prepare("INSERT INTO outbox(topic, payload) VALUES(?,?)").bind(topic).bind(payload).run();
        connection_.prepare("DELETE FROM outbox WHERE id<=?").bind(connection_.last_row() - most).run();
    });
}

std::optional<Generation> Archive::latest() const {
    try {
        Statement rows = connection_.prepare(kGenerations);
        while (rows.step()) {
            try {
                Generation generation = generation_from(rows);
                generation.answers = answers_of(connection_, generation.visit, generation.offer.round);
                return generation;
            } catch (const base::InputError&) {
                continue;
            }
        }
    } catch (const SqliteError&) {
        return std::nullopt;
    }
    return std::nullopt;
}

bool Archive::is_open(std::int64_t visit) const {
    try {
        Statement row = connection_.prepare("SELECT 1 FROM visit WHERE id=? AND ended_ms IS NULL");
        return row.bind(visit).step();
    } catch (const SqliteError&) {
        return false;
    }
}

}  // namespace quadrat::exhibit
