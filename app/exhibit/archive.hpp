// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/seed.hpp"
#include "exhibit/sqlite.hpp"
#include "exhibit/visit.hpp"
#include "genome/offer.hpp"
#include "genome/word_answer.hpp"

namespace quadrat::exhibit {

using WallTime = std::chrono::sys_time<std::chrono::milliseconds>;

// Why something was not kept, in one line; nothing when it was. The exhibit says so and goes on.
using Trouble = std::optional<std::string>;

// The four that were on screen, and all that is needed to go on from them.
struct Generation {
    std::int64_t visit = 0;
    base::Seed seed;       // the session's
    base::Seed flight;     // the camera's path
    std::string breeder;   // its name
    std::string belief;    // JSON, the breeder's own
    genome::Offer offer;   // the round is in it
    genome::Pick answers;  // of this round, so far
    friend bool operator==(const Generation&, const Generation&) = default;
};

// How much is kept; the oldest goes first. A generation takes about 4 kB with 21 parameters, a visit under 1 kB.
struct Retention {
    int generations = 1000;
    int visits = 200'000;
    int word_answers = 5000;  // about 5 kB each
};

// What visitors said of landscapes, oldest first. Rows that cannot be read, or that speak of words or parameters which
// this program does not have, are counted alone.
struct WordAnswers {
    std::vector<genome::WordAnswer> readable;
    int unreadable = 0;
};

// What visitors did and where the exhibit stands, in one SQLite file (WAL, synchronous=FULL), quadrat.db.
// Each call is one transaction: after a kill or a pulled plug all of it is there or none. No personal data.
class Archive {
  public:
    enum class Condition {
        Fresh,       // there was no file
        Continued,   // the file was good
        Replaced,    // the file was damaged; set aside, and a fresh one opened
        MemoryOnly,  // the directory cannot be written; kept until the program ends
    };
    struct Opened;

    // Never throws for what it finds on disk. A damaged file (not SQLite, cut off, a schema version from the future, a check that
    // fails, a last row that cannot be read) is renamed, with its -wal and -shm, to quadrat.db.damaged-YYYYMMDD-HHMMSS
    // in UTC. An older schema version is brought up to date. The directory is created when missing.
    static Opened open(const std::filesystem::path& directory, WallTime now, const Retention& retention = {});

    // The number of a new visit, from 1; unique in the file, also when writing it failed.
    struct Begun;
    Begun begin_visit(WallTime at);
    [[nodiscard]] Trouble end_visit(std::int64_t visit, Ending ending, int rounds, WallTime at);

    // Call it before the four are shown.
    [[nodiscard]] Trouble append(const Generation& generation);

    // The answers of the last generation, which must be of this visit and round; and when each was given or changed.
    [[nodiscard]] Trouble keep_answers(std::int64_t visit, int round, const genome::Pick& answers, WallTime at);

    // What a visitor said of a landscape, and when; nothing of the visitor.
    [[nodiscard]] Trouble keep_word(const genome::WordAnswer& answer, WallTime at);
    WordAnswers word_answers() const;

    // One short text under a name, in place of the one before; and what it is, "" where there is none.
    [[nodiscard]] Trouble remember(std::string_view name, std::string_view value);
    std::string remembered(std::string_view name) const;

    // A message for the fleet, kept until it was sent (outbox.hpp); the oldest goes when there are more than `most`.
    struct Message {
        std::int64_t id = 0;
        std::string topic, payload;
    };
    [[nodiscard]] Trouble post(std::string_view topic, std::string_view payload, int most = 10'000);

    // The last whole generation; an older one when rows after it cannot be read. Nothing when there is none.
    std::optional<Generation> latest() const;

    // Whether the visit has begun and not ended: to be taken up again after a pulled plug.
    bool is_open(std::int64_t visit) const;

  private:
    Archive(Connection connection, const Retention& retention);

    // The three ways open() may go. open_file throws DamageError and SqliteError; the others follow from them.
    static Opened open_file(const std::filesystem::path& file, WallTime now, const Retention& retention);
    static Opened open_in_memory(const std::filesystem::path& file, std::string_view why, WallTime now,
                                 const Retention& retention);
    static Opened replace(const std::filesystem::path& file, std::string_view damage, WallTime now,
                          const Retention& retention);

    // Throws DamageError when the last row is not whole, or a number is beyond what we ever write.
    void require_whole() const;

    template <typename Work>
    Trouble attempt(std::string_view what, const Work& work);

    Connection connection_;
    Retention retention_;
    std::int64_t last_visit_ = 0;
};

// For an older program, or back again: moves the file's tables to a schema version, all or nothing, while no exhibit
// uses it. Returns the version it had. Throws InputError.
int move_state(const std::filesystem::path& directory, int version);
int state_version();  // that this program keeps

struct Archive::Opened {
    Archive archive;
    Condition condition;
    std::string message;  // one line: what was found, and what was done about it
};

struct Archive::Begun {
    std::int64_t visit;
    Trouble trouble;
};

}  // namespace quadrat::exhibit
