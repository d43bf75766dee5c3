// SPDX-License-Identifier: Apache-2.0
// The room `learning`: what a site keeps of its visits and learns from them. The archive's thread, the diary of a
// visit, its lineage of breeders, the word map's training at night. Nothing here runs a visit (exhibit) or grows
// anything.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "exhibit/visit.hpp"
#include "genome/word_answer.hpp"
#include "learning/keeper.hpp"

namespace quadrat::learning {

// What is written down of visits while they go on. No call waits for the disk, unless it says so.
class Diary {
  public:
    enum class ToldTo { Nobody, Fleet };  // that a visit has ended: whoever publishes it

    Diary(std::unique_ptr<Keeper> keeper, std::function<archive::WallTime()> wall_time, ToldTo told_to);

    // What the last run left, once; nothing until that is known, and after it was told.
    std::optional<archive::Kept> take_left_behind();

    void begin_visit();
    void go_on_with_visit(std::int64_t number);
    // Of the visit under way. Done when it may be shown.
    Keeper::Ticket keep(archive::Generation generation);
    void keep_answers(int round, const genome::Pick& answers);
    void keep_word(const genome::WordAnswer& answer);
    void end_visit(const exhibit::EndVisit& how);
    std::int64_t today() const;  // in days since 1970
    int visits_ended() const { return visits_ended_; }

    // Keeps a short text for the next run, in place of the one under the same name.
    void remember(const std::string& name, std::string text);

    // Waits at most `patience`. True: it is on disk, or the disk has had so long that the visit goes on without it.
    bool is_kept(Keeper::Ticket ticket, std::chrono::nanoseconds patience);
    std::string trouble();  // why what visitors do is not being kept, or ""
    Keeper& keeper() { return *keeper_; }

  private:
    std::unique_ptr<Keeper> keeper_;
    std::function<archive::WallTime()> wall_time_;
    ToldTo told_to_;
    bool was_told_ = false;                // what the last run left
    std::shared_ptr<std::int64_t> visit_;  // its number in the archive, written and read by the keeper's thread
    int visits_ended_ = 0;
};

}  // namespace quadrat::learning
