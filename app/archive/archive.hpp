// SPDX-License-Identifier: Apache-2.0
// The room `archive`: what is kept on disk, in one SQLite file, and who may write it. Nothing here decides what happens
// next (exhibit) or waits on a thread of its own (learning/keeper).
#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "archive/deeds.hpp"
#include "archive/sqlite.hpp"
#include "base/seed.hpp"
#include "exhibit/visit.hpp"
#include "genome/offer.hpp"
#include "genome/word_answer.hpp"

namespace quadrat::archive {

using WallTime = std::chrono::sys_time<std::chrono::milliseconds>;

// Why something was not kept, in one line; nothing when it was. The exhibit says so and goes on.
using Trouble = std::optional<std::string>;

// The four that were on screen, by what they came from: the same deeds lead to the same four again.
struct Generation {
    std::int64_t visit = 0;
    int round = 1;
    base::Seed seed;           // the session's
    std::string breeder;       // its name
    std::vector<Deed> deeds;   // since the visit began; as many as rounds before this one
    std::uint64_t digest = 0;  // of the offer, digest_of(): what the deeds led to
    genome::Pick answers;      // of this round, so far
    friend bool operator==(const Generation&, const Generation&) = default;
};

std::uint64_t digest_of(const genome::Offer& offer);

// Of each visit its last generation, oldest visit first: with its deeds and answers, all that was picked in it. Rows
// that cannot be read are passed over. Throws SqliteError.
std::vector<Generation> last_generations_of(const Connection& connection);

// The newest visit, if it has not ended: it is under way, or was interrupted and may be taken up. Throws SqliteError.
std::optional<std::int64_t> open_visit_of(const Connection& connection);

// How much is kept; the oldest goes first, a few at a time. A visit of six rounds takes about 1 kB.
struct Retention {
    int visits = 200'000;     // with their generations and answers
    int word_answers = 5000;  // about 2 kB a landscape
};

// What visitors said of landscapes, oldest first. Rows that cannot be read, or that speak of words or parameters which
// this program does not have, are counted alone.
struct WordAnswers {
    std::vector<genome::WordAnswer> readable;
    int unreadable = 0;
};

// What an exhibit that was switched off goes on with.
struct Kept {
    std::optional<Generation> interrupted;                              // the last one, of a visit that has not ended
    std::string buttons, detail, gpu, language, collection, described;  // what was remembered under these names
};
using TellKept = std::function<void(const Kept&)>;

enum class Durability {
    Flushed,  // on the disk when the call returns
    Written,  // with the system: a kill loses nothing, a pulled plug the last seconds
};

// What visitors did and where the exhibit stands, in one SQLite file (WAL), quadrat.db. Each call is one transaction,
// flushed to the disk, or part of the one that together() makes of several: after a kill or a pulled plug all of it is
// there or none. No personal data.
class Archive {
  public:
    enum class Condition {
        Fresh,       // there was no file
        Continued,   // the file was good
        Replaced,    // the file was damaged; set aside, and a fresh one opened
        MemoryOnly,  // the directory cannot be written; kept until the program ends
    };
    struct Opened;

    // Never throws for what it finds on disk. A damaged file (not SQLite, cut off, a schema version from the future, a
    // check that fails, a last row that cannot be read) is renamed, with its -wal and -shm, to
    // quadrat.db.damaged-YYYYMMDD-HHMMSS in UTC. An older schema version is brought up to date. The directory is
    // created when missing.
    // `tell` hears what was kept as soon as it is known: before anything is written, for which a disk may take seconds,
    // and before the whole file is checked, which takes longer the more there is in it. It hears once more, of nothing,
    // where the file turns out to be of no use.
    static Opened open(const std::filesystem::path& directory, WallTime now, const Retention& retention = {},
                       const TellKept& tell = {});

    // One transaction of all calls that `work` makes, so that what belongs together is written once. What could not be
    // kept, each call says; the trouble here is that of the whole.
    [[nodiscard]] Trouble together(Durability durability, const std::function<void()>& work);

    // The number of a new visit, from 1; unique in the file, also when writing it failed.
    struct Begun;
    Begun begin_visit(WallTime at);
    [[nodiscard]] Trouble end_visit(std::int64_t visit, exhibit::Ending ending, int rounds, WallTime at);

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

    Kept kept() const;

    // Whether the visit has begun and not ended: to be taken up again after a pulled plug.
    bool is_open(std::int64_t visit) const;

    // Throws DamageError when the last row is not whole, or a number is beyond what we ever write.
    static void require_whole(const Connection& connection);

  private:
    Archive(Connection connection, const Retention& retention);

    // The three ways open() may go. open_file throws DamageError and SqliteError; the others follow from them.
    static Opened open_file(const std::filesystem::path& file, WallTime now, const Retention& retention,
                            const TellKept& tell);
    static Opened open_in_memory(const std::filesystem::path& file, std::string_view why, WallTime now,
                                 const Retention& retention, const TellKept& tell);
    static Opened replace(const std::filesystem::path& file, std::string_view damage, WallTime now,
                          const Retention& retention, const TellKept& tell);

    static Kept kept_in(const Connection& connection);

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

}  // namespace quadrat::archive
