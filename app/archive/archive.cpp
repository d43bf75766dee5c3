// SPDX-License-Identifier: Apache-2.0
#include "archive/archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "archive/archive_schema.hpp"
#include "archive/scene_rows.hpp"
#include "archive/visit_rows.hpp"
#include "archive/word_answers.hpp"
#include "base/error.hpp"
#include "genome/json_text.hpp"
#include "genome/offer_json.hpp"
#include "genome/words_json.hpp"

namespace quadrat::archive {
namespace {

std::string_view name_of(exhibit::Ending ending) {
    switch (ending) {
        case exhibit::Ending::Finished:
            return "finished";
        case exhibit::Ending::Left:
            return "left";
        case exhibit::Ending::Stuck:
            return "stuck";
    }
    return "";
}

std::int64_t milliseconds_of(WallTime at) { return at.time_since_epoch().count(); }

std::int64_t as_integer(std::uint64_t value) { return static_cast<std::int64_t>(value); }

// Rows of an older program hold answers alone.
constexpr std::string_view kGenerations =
    "SELECT visit, round, seed, breeder, deeds, digest, ifnull(trees, -1), ifnull(land, -1), ifnull(sky, -1) "
    "FROM generation WHERE digest IS NOT NULL ORDER BY id DESC";
constexpr std::int64_t kSpare_pages = 2048;
constexpr std::int64_t kForgotten_visits = 16;  // at once: a page that is written for one row is written for nothing
constexpr std::int64_t kForgotten_generations = 1000;           // at most
constexpr std::int64_t kLargestNumber = std::int64_t{1} << 53;  // of a visit or a row; leaves room to count on

// Throws InputError when the row is not whole.
Generation generation_from(const Statement& row) {
    Generation generation;
    generation.visit = row.integer(0);
    generation.seed.value = static_cast<std::uint64_t>(row.integer(2));
    generation.breeder = row.text(3);
    generation.deeds = deeds_from(row.text(4));
    generation.digest = static_cast<std::uint64_t>(row.integer(5));
    if (row.integer(1) != static_cast<std::int64_t>(generation.deeds.size()) + 1)
        throw base::InputError("its round is not that of its deeds");
    generation.round = static_cast<int>(row.integer(1));
    for (std::size_t i = 0; i < genome::kAspects.size(); ++i) {
        const std::int64_t candidate = row.integer(6 + static_cast<int>(i));
        if (candidate >= std::int64_t{genome::kCandidates}) throw base::InputError("there is no such candidate");
        if (candidate >= 0) generation.answers[genome::kAspects[i]] = static_cast<std::size_t>(candidate);
    }
    return generation;
}

Statement& bind_answers(Statement& statement, const genome::Pick& answers) {
    for (const genome::Aspect aspect : genome::kAspects) {
        if (answers[aspect])
            statement.bind(static_cast<std::int64_t>(*answers[aspect]));
        else
            statement.bind_nothing();
    }
    return statement;
}

// An older one when rows after it cannot be read.
std::optional<Generation> latest_in(const Connection& connection) {
    try {
        Statement rows = connection.prepare(kGenerations);
        while (rows.step()) {
            try {
                return generation_from(rows);
            } catch (const base::InputError&) {
                continue;
            }
        }
    } catch (const SqliteError&) {
        return std::nullopt;
    }
    return std::nullopt;
}

bool is_open_in(const Connection& connection, std::int64_t visit) {
    try {
        Statement row = connection.prepare("SELECT 1 FROM visit WHERE id=? AND ended_ms IS NULL");
        return row.bind(visit).step();
    } catch (const SqliteError&) {
        return false;
    }
}

// Of one landscape several words are asked.
bool is_of_the_last_scene(const Connection& connection, const std::string& scene, const std::string& made_of) {
    Statement last =
        connection.prepare("SELECT scene, made_of FROM word_answer WHERE scene<>'' ORDER BY id DESC LIMIT 1");
    return last.step() && last.text(0) == scene && last.text(1) == made_of;
}

}  // namespace

std::uint64_t digest_of(const genome::Offer& offer) { return base::Seed{}.child(genome::to_json(offer)).value; }

std::vector<Generation> last_generations_of(const Connection& connection) {
    std::vector<Generation> last;
    std::set<std::int64_t> visits;
    Statement rows = connection.prepare(kGenerations);
    while (rows.step()) {
        try {
            Generation generation = generation_from(rows);
            if (visits.insert(generation.visit).second) last.push_back(std::move(generation));
        } catch (const base::InputError&) {
            continue;
        }
    }
    std::ranges::reverse(last);
    return last;
}

std::optional<std::int64_t> open_visit_of(const Connection& connection) {
    Statement rows =
        connection.prepare("SELECT id FROM visit WHERE id=(SELECT max(id) FROM visit) AND ended_ms IS NULL");
    if (!rows.step()) return std::nullopt;
    return rows.integer(0);
}

Archive::Archive(Connection connection, const Retention& retention)
    : connection_(std::move(connection)),
      retention_(retention),
      last_visit_(connection_.integer("SELECT max(id) FROM visit")) {}

void Archive::require_whole(const Connection& connection) {
    if (connection.integer("SELECT min(id) FROM visit") < 0 ||
        connection.integer("SELECT max(id) FROM visit") > kLargestNumber ||
        connection.integer("SELECT max(seq) FROM sqlite_sequence") > kLargestNumber ||
        connection.integer("SELECT max(id) FROM generation") > kLargestNumber)
        throw DamageError("it holds numbers that were never written");
    try {
        Statement rows = connection.prepare(kGenerations);
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

Trouble Archive::together(Durability durability, const std::function<void()>& work) {
    std::optional<Transaction> all;
    try {
        connection_.run(durability == Durability::Flushed ? "PRAGMA synchronous=FULL" : "PRAGMA synchronous=NORMAL");
        all.emplace(connection_);
    } catch (const SqliteError&) {
        all.reset();  // each call then says for itself what is wrong
    }
    work();
    try {
        if (all && connection_.is_in_transaction()) all->commit();
        connection_.run("PRAGMA synchronous=FULL");
        return std::nullopt;
    } catch (const SqliteError& error) {
        return fmt::format("cannot keep what was done last: {}", error.what());
    }
}

Archive::Begun Archive::begin_visit(WallTime at) {
    const std::int64_t visit = ++last_visit_;
    Trouble trouble = attempt("the visit", [&] {
        connection_.prepare("INSERT INTO visit(id, began_ms) VALUES(?,?)").bind(visit).bind(milliseconds_of(at)).run();
        if (visit % kForgotten_visits != 0) return;
        const std::int64_t oldest = visit - retention_.visits;
        connection_.prepare("DELETE FROM visit WHERE id<=?").bind(oldest).run();
        // The oldest stand first: nobody looks through all of them.
        connection_
            .prepare("DELETE FROM generation WHERE visit<=? AND id IN (SELECT id FROM generation ORDER BY id LIMIT ?)")
            .bind(oldest)
            .bind(kForgotten_generations)
            .run();
    });
    return {visit, std::move(trouble)};
}

Trouble Archive::end_visit(std::int64_t visit, exhibit::Ending ending, int rounds, WallTime at) {
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
        Statement row = connection_.prepare(
            "INSERT INTO generation(visit, round, seed, breeder, deeds, digest, trees, land, sky) "
            "VALUES(?,?,?,?,?,?,?,?,?)");
        row.bind(generation.visit)
            .bind(generation.round)
            .bind(as_integer(generation.seed.value))
            .bind(generation.breeder)
            .bind(to_text(generation.deeds))
            .bind(as_integer(generation.digest));
        bind_answers(row, generation.answers).run();
    });
    if (trouble) return trouble;
    try {
        // A few pages a time give back what was deleted, without a pause that anyone could notice. What the next
        // generations will fill again stays: pages that come and go wear a card out.
        if (connection_.integer("PRAGMA freelist_count") > kSpare_pages)
            connection_.prepare("PRAGMA incremental_vacuum(64)").run();
    } catch (const SqliteError& error) {
        return fmt::format("kept the generation, but cannot give back disk space: {}", error.what());
    }
    return std::nullopt;
}

Trouble Archive::keep_answers(std::int64_t visit, int round, const genome::Pick& answers, WallTime at) {
    return attempt("the answers", [&] {
        // An answer that stands keeps its time.
        Statement row = connection_.prepare(
            "UPDATE generation SET trees=?1, land=?2, sky=?3,"
            " trees_ms=CASE WHEN ?1 IS NULL THEN NULL WHEN trees IS ?1 THEN trees_ms ELSE ?4 END,"
            " land_ms=CASE WHEN ?2 IS NULL THEN NULL WHEN land IS ?2 THEN land_ms ELSE ?4 END,"
            " sky_ms=CASE WHEN ?3 IS NULL THEN NULL WHEN sky IS ?3 THEN sky_ms ELSE ?4 END"
            " WHERE id=(SELECT max(id) FROM generation) AND visit=?5 AND round=?6");
        bind_answers(row, answers).bind(milliseconds_of(at)).bind(visit).bind(round).run();
    });
}

Trouble Archive::keep_word(const genome::WordAnswer& answer, WallTime at) {
    return attempt("what was said of the landscape", [&] {
        std::string scene = scene_row(connection_, answer.scene);
        std::string made_of = answer.made_of ? genome::words_json(*answer.made_of) : "";
        if (is_of_the_last_scene(connection_, scene, made_of)) scene = made_of = "";
        connection_.prepare("INSERT INTO word_answer(at_ms, word, step, scene, made_of) VALUES(?,?,?,?,?)")
            .bind(milliseconds_of(at))
            .bind(word(answer.word).name)
            .bind(static_cast<std::int64_t>(answer.step))
            .bind(scene)
            .bind(made_of)
            .run();
        const std::int64_t oldest = connection_.last_row() - std::max(1, retention_.word_answers);
        // With a scene go those that were said of it.
        connection_
            .prepare(
                "DELETE FROM word_answer WHERE id<=?1 OR "
                "id<(SELECT min(id) FROM word_answer WHERE id>?1 AND scene<>'')")
            .bind(oldest)
            .run();
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

std::string Archive::remembered(std::string_view name) const { return archive::remembered(connection_, name); }

Trouble Archive::post(std::string_view topic, std::string_view payload, int most) {
    return attempt("a message", [&] {
        connection_.prepare("INSERT INTO outbox(topic, payload) VALUES(?,?)").bind(topic).bind(payload).run();
        connection_.prepare("DELETE FROM outbox WHERE id<=?").bind(connection_.last_row() - most).run();
    });
}

std::optional<Generation> Archive::latest() const { return latest_in(connection_); }

bool Archive::is_open(std::int64_t visit) const { return is_open_in(connection_, visit); }

Kept Archive::kept_in(const Connection& connection) {
    Kept kept;
    kept.interrupted = latest_in(connection);
    if (kept.interrupted && !is_open_in(connection, kept.interrupted->visit)) kept.interrupted.reset();
    kept.buttons = archive::remembered(connection, "buttons");
    kept.detail = archive::remembered(connection, "detail");
    kept.gpu = archive::remembered(connection, "gpu");
    kept.language = archive::remembered(connection, "language");
    kept.collection = archive::remembered(connection, "collection");
    kept.described = archive::remembered(connection, "described");
    return kept;
}

Kept Archive::kept() const { return kept_in(connection_); }

}  // namespace quadrat::archive
