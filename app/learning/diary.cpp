// SPDX-License-Identifier: Apache-2.0
#include "learning/diary.hpp"

#include <fmt/format.h>

#include <utility>

#include "archive/outbox.hpp"

namespace quadrat::learning {
namespace {

using Urgency = Keeper::Urgency;

// A healthy disk takes milliseconds, a bad card seconds; one that hangs must not end the visit.
constexpr std::chrono::seconds kDiskPatience{4};

}  // namespace

Diary::Diary(std::unique_ptr<Keeper> keeper, std::function<archive::WallTime()> wall_time, ToldTo told_to)
    : keeper_(std::move(keeper)),
      wall_time_(std::move(wall_time)),
      told_to_(told_to),
      visit_(std::make_shared<std::int64_t>(0)) {}

std::optional<archive::Kept> Diary::take_left_behind() {
    if (was_told_) return std::nullopt;
    auto kept = keeper_->kept();
    was_told_ = kept.has_value();
    return kept;
}

void Diary::begin_visit() {
    visit_ = std::make_shared<std::int64_t>(0);
    keeper_->post(
        [visit = visit_, at = wall_time_()](archive::Archive& archive) {
            const auto begun = archive.begin_visit(at);
            *visit = begun.visit;
            return begun.trouble;
        },
        Urgency::Soon);
}

void Diary::go_on_with_visit(std::int64_t number) { *visit_ = number; }

Keeper::Ticket Diary::keep(archive::Generation generation) {
    // The first four cost the visitor nothing yet, and many visits end with them.
    const Urgency urgency = generation.deeds.empty() ? Urgency::Written : Urgency::Flushed;
    return keeper_->post(
        [generation = std::move(generation), visit = visit_](archive::Archive& archive) mutable {
            generation.visit = *visit;
            return archive.append(generation);
        },
        urgency);
}

void Diary::keep_answers(int round, const genome::Pick& answers) {
    keeper_->post([visit = visit_, round, answers, at = wall_time_()](
                      archive::Archive& archive) { return archive.keep_answers(*visit, round, answers, at); },
                  Urgency::Soon);
}

void Diary::keep_word(const genome::WordAnswer& answer) {
    keeper_->post([answer, at = wall_time_()](archive::Archive& archive) { return archive.keep_word(answer, at); },
                  Urgency::Soon);
}

void Diary::end_visit(const exhibit::EndVisit& how) {
    ++visits_ended_;
    if (told_to_ == ToldTo::Fleet)
        keeper_->post([text = archive::told_of_visit(how.ending, how.rounds, wall_time_())](
                          archive::Archive& archive) { return archive.post("visits", text); },
                      Urgency::Soon);
    keeper_->post([visit = visit_, how, at = wall_time_()](
                      archive::Archive& archive) { return archive.end_visit(*visit, how.ending, how.rounds, at); },
                  Urgency::Soon);
}

std::int64_t Diary::today() const {
    return std::chrono::floor<std::chrono::days>(wall_time_()).time_since_epoch().count();
}

void Diary::remember(const std::string& name, std::string text) {
    keeper_->post([name, text = std::move(text)](archive::Archive& archive) { return archive.remember(name, text); },
                  Urgency::Soon);
}

bool Diary::is_kept(Keeper::Ticket ticket, std::chrono::nanoseconds patience) {
    return keeper_->is_done(ticket, patience) || keeper_->waited_for() >= kDiskPatience;
}

std::string Diary::trouble() {
    const auto waited = keeper_->waited_for();
    if (waited < kDiskPatience) return keeper_->trouble();
    return fmt::format("the disk has not answered for {} s",
                       std::chrono::duration_cast<std::chrono::seconds>(waited).count());
}

}  // namespace quadrat::learning
