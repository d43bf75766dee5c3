// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/button_health.hpp"

#include <algorithm>
#include <utility>

namespace quadrat::firmware_io {
namespace {

using namespace std::chrono_literals;

constexpr Instant kEdgeWindow = 1s;
constexpr std::array<std::string_view, kAilments.size()> kNames{"leaned on",        "stuck",      "chattering", "dead",
                                                                "pressed together", "all pressed"};

constexpr std::size_t index_of(Ailment ailment) { return static_cast<std::size_t>(ailment); }

}  // namespace

std::string_view name_of(Ailment ailment) { return kNames[index_of(ailment)]; }

ButtonHealth::ButtonHealth(HealthLimits limits, HealthMemory memory) : limits_{limits}, memory_{memory} {}

std::vector<FindingChange> ButtonHealth::take_changes() { return std::exchange(changes_, {}); }

bool ButtonHealth::has(Ailment ailment, Button button) const {
    return std::any_of(findings_.begin(), findings_.end(),
                       [&](const Finding& f) { return f.ailment == ailment && f.button == button; });
}

// Begins or ends a finding, if that is news.
void ButtonHealth::note(Ailment ailment, Button button, bool is_present, Instant since, Instant now) {
    const auto found = std::find_if(findings_.begin(), findings_.end(),
                                    [&](const Finding& f) { return f.ailment == ailment && f.button == button; });
    if (is_present == (found != findings_.end())) return;
    if (is_present) {
        findings_.push_back({ailment, button, since});
        changes_.push_back({Turn::Began, findings_.back(), now});
        ++counts_[index_of(ailment)][firmware_io::index_of(button)];
    } else {
        changes_.push_back({Turn::Ended, *found, now});
        findings_.erase(found);
    }
}

// Only what was heard says that a button lives and others are pressed: a chattering one presses nobody's.
void ButtonHealth::remember_press(Button pressed) {
    last_pressed_ = pressed;
    for (std::uint64_t& presses : memory_.others_pressed) ++presses;
    memory_.others_pressed[firmware_io::index_of(pressed)] = 0;
    memory_.unpressed_for[firmware_io::index_of(pressed)] = Instant{0};
}

bool ButtonHealth::is_chattering(Watch& watch, const Contact& contact, Instant now) const {
    watch.samples.push_back({now, contact.raw_edges});
    while (watch.samples.size() > 2 && now - watch.samples[1].at >= kEdgeWindow) watch.samples.pop_front();
    const Sample& oldest = watch.samples.front();
    const double seconds = std::chrono::duration<double>{std::max(now - oldest.at, kEdgeWindow)}.count();
    const double edges_per_s = static_cast<double>(contact.raw_edges - oldest.raw_edges) / seconds;
    const auto& presses = watch.presses;
    return edges_per_s >= limits_.chatter_edges_per_s ||
           (presses.size() >= limits_.chatter_presses && presses.back() - presses.front() <= limits_.chatter_window &&
            now - presses.back() <= limits_.chatter_window);
}

void ButtonHealth::observe(Button button, const Contact& contact, Instant now) {
    Watch& watch = watches_[firmware_io::index_of(button)];
    const bool is_chattering_now = is_chattering(watch, contact, now);
    // A contact found closed at the start is no Down, but it is stuck all the same.
    const bool is_held = contact.is_down || contact.is_closed;
    const Instant since = contact.is_down ? contact.down_since : contact.closed_since;
    const bool is_stuck_now = is_held && now - since >= limits_.stuck_after;
    if (is_held || is_chattering_now) watch.quiet_since = now;
    if (is_stuck_now) note(Ailment::Stuck, button, true, since, now);
    if (is_chattering_now) note(Ailment::Chattering, button, true, now, now);
    if (now - watch.quiet_since >= limits_.recovers_after) {
        note(Ailment::Stuck, button, false, since, now);
        note(Ailment::Chattering, button, false, since, now);
    }
    watch.is_masked = has(Ailment::Stuck, button) || has(Ailment::Chattering, button);
    const bool is_leaned_on = is_held && !watch.is_masked && now - since >= limits_.leaned_on_after;
    note(Ailment::LeanedOn, button, is_leaned_on, since, now);
}

void ButtonHealth::observe_together(const Contacts& contacts, Instant now) {
    const auto is_in_play = [&](Button button) {
        const Watch& watch = watches_[firmware_io::index_of(button)];
        return button != Button::Back && !watch.is_masked && contacts[firmware_io::index_of(button)].is_down;
    };
    const auto down = std::count_if(kButtons.begin(), kButtons.end(), is_in_play);
    const auto follow = [&](Ailment ailment, bool is_present) {
        const auto found = std::find_if(findings_.begin(), findings_.end(),
                                        [&](const Finding& finding) { return finding.ailment == ailment; });
        note(ailment, found != findings_.end() ? found->button : last_pressed_, is_present, now, now);
    };
    follow(Ailment::PressedTogether, down >= 2);
    follow(Ailment::AllPressed, down == 4);
}

void ButtonHealth::observe_dead(Button button, Instant now) {
    const std::size_t i = firmware_io::index_of(button);
    memory_.unpressed_for[i] += now - heard_at_.value_or(now);
    note(Ailment::Dead, button,
         memory_.unpressed_for[i] >= limits_.dead_after && memory_.others_pressed[i] >= limits_.dead_after_presses,
         now - memory_.unpressed_for[i], now);
}

std::vector<ButtonEdge> ButtonHealth::hear(const std::vector<ButtonEdge>& edges, const Contacts& contacts,
                                           Instant now) {
    std::vector<ButtonEdge> heard;
    for (const ButtonEdge& edge : edges) {
        Watch& watch = watches_[firmware_io::index_of(edge.button)];
        const bool is_down = edge.motion == Motion::Down;
        if (is_down) watch.presses.push_back(edge.at);
        if (watch.presses.size() > limits_.chatter_presses) watch.presses.pop_front();
        if (is_down == watch.is_heard_down || (is_down && watch.is_masked)) continue;
        watch.is_heard_down = is_down;
        if (is_down) remember_press(edge.button);
        heard.push_back(edge);
    }
    for (const Button button : kButtons) {
        const std::size_t i = firmware_io::index_of(button);
        observe(button, contacts[i], now);
        observe_dead(button, now);
        if (watches_[i].is_masked && std::exchange(watches_[i].is_heard_down, false))
            heard.push_back({button, Motion::Up, now});
    }
    observe_together(contacts, now);
    heard_at_ = now;
    return heard;
}

}  // namespace quadrat::firmware_io
