// SPDX-License-Identifier: Apache-2.0
#include "unit/display/scripted_screen.hpp"

#include <algorithm>
#include <utility>

namespace quadrat::display::testing {

int ScriptedScreen::count(const std::string& what) const {
    return static_cast<int>(std::count(journal.begin(), journal.end(), what));
}

// Goes to the next thing that happens, or to the end of the wait.
std::vector<News> ScriptedScreen::wait(Instant at_most) {
    const Instant until = now_ + at_most;
    for (;;) {
        Instant next = until;
        if (!script_.empty()) next = std::min(next, std::max(now_, script_.begin()->first));
        if (flip_ends_at_) next = std::min(next, std::max(now_, *flip_ends_at_));
        now_ = news_.empty() ? next : now_;
        if (flip_ends_at_ && *flip_ends_at_ <= now_) {
            news_.push_back(FlipShown{*std::exchange(flip_ends_at_, std::nullopt) + flip_skew});
        }
        while (!script_.empty() && script_.begin()->first <= now_) {
            const auto happens = script_.begin()->second;
            script_.erase(script_.begin());
            happens(*this);
        }
        if (!news_.empty() || now_ >= until) return std::exchange(news_, {});
    }
}

ProbeResult ScriptedScreen::probe() {
    journal.push_back("probe");
    if (!has_card) return NothingFound{"no graphics card", false};
    if (is_denied) return NothingFound{"permission denied", true};
    if (!is_connected) return CardFound{"HDMI-A-1 has no screen"};
    const bool was_bad = std::exchange(is_link_bad, false);
    return ScreenFound{32, "HDMI-A-1", edid, was_bad, rungs};
}

std::optional<event::PlugMoved> ScriptedScreen::glance() {
    journal.push_back("glance");
    if (is_connected && !is_link_bad) return std::nullopt;
    return event::PlugMoved{!is_connected};
}

Refusal ScriptedScreen::next_answer(std::deque<Refusal>& answers, Refusal otherwise) {
    if (!has_card) return Refusal::NoDevice;
    if (answers.empty()) return otherwise;
    const Refusal answer = answers.front();
    answers.pop_front();
    return answer;
}

Refusal ScriptedScreen::modeset(int rung) {
    journal.push_back("modeset " + std::to_string(rung));
    return next_answer(modeset_answers, every_modeset);
}

void ScriptedScreen::disable() {
    journal.push_back("disable");
    flip_ends_at_.reset();
}

void ScriptedScreen::close_card() {
    journal.push_back("close");
    flip_ends_at_.reset();
}

std::optional<Refusal> ScriptedScreen::flip() {
    journal.push_back("flip");
    if (std::exchange(is_context_lost, false)) return std::nullopt;
    const Refusal answer = next_answer(flip_answers, every_flip);
    if (answer == Refusal::None && !are_flips_lost) {
        const auto frames = now_ / kPeriod + 1;  // at the next retrace
        flip_ends_at_ = frames * kPeriod;
    }
    return answer;
}

}  // namespace quadrat::display::testing
