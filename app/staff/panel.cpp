// SPDX-License-Identifier: Apache-2.0
#include "staff/panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "base/log.hpp"

namespace quadrat::staff {
namespace {

using firmware_io::Button;
using firmware_io::ButtonEdge;
using firmware_io::index_of;
using firmware_io::Instant;
using firmware_io::LampPattern;
using firmware_io::Motion;

constexpr Instant kWink = std::chrono::milliseconds{150};

bool is_everyday(firmware_io::Ailment ailment) {
    return ailment == firmware_io::Ailment::PressedTogether || ailment == firmware_io::Ailment::AllPressed;
}

bool is_of_chord(Button button) { return button == Panel::kChord[0] || button == Panel::kChord[1]; }

}  // namespace

std::string describe(const firmware_io::Finding& finding, Instant now) {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now - finding.since).count();
    return fmt::format("button {} is {}, since {} s", name_of(finding.button), name_of(finding.ailment), seconds);
}

std::string to_text(const firmware_io::HealthMemory& memory) {
    std::string text;
    for (std::size_t i = 0; i < firmware_io::kButtons.size(); ++i)
        text += fmt::format("{} {} ", std::chrono::duration_cast<std::chrono::seconds>(memory.unpressed_for[i]).count(),
                            memory.others_pressed[i]);
    return text;
}

firmware_io::HealthMemory health_memory_from(const std::string& text) {
    constexpr long long kLongest_s = 1LL << 32;
    firmware_io::HealthMemory memory;
    std::istringstream stream(text);
    for (std::size_t i = 0; i < firmware_io::kButtons.size(); ++i) {
        long long seconds = 0, presses = 0;
        if (!(stream >> seconds >> presses) || seconds < 0 || seconds > kLongest_s || presses < 0) return {};
        memory.unpressed_for[i] = std::chrono::seconds{seconds};
        memory.others_pressed[i] = static_cast<std::uint64_t>(presses);
    }
    return memory;
}

Panel::Panel(firmware_io::ButtonSource& buttons, firmware_io::HealthMemory memory)
    : buttons_(buttons), health_({}, memory) {
    pressed_at_.fill(-kWink);
}

std::vector<ButtonEdge> Panel::poll(Instant now) {
    const auto edges = buttons_.poll(now);
    std::vector<ButtonEdge> heard = health_.hear(edges, buttons_.contacts(), now);
    time_chord(edges, now);
    keep_chord_from(heard, now);
    for (const ButtonEdge& edge : heard) {
        if (edge.motion == Motion::Up) continue;
        ++presses_;
        ++presses_of_[index_of(edge.button)];
        pressed_at_[index_of(edge.button)] = edge.at;
    }
    tell();
    return heard;
}

// From when the buttons went down, not from when a frame heard of it: a frame may come late.
void Panel::time_chord(const std::vector<ButtonEdge>& edges, Instant now) {
    const auto tell_if_due = [&](Instant at) {
        if (!is_chord_held() || is_chord_told_) return;
        is_chord_told_ = at - std::max(*chord_down_at_[0], *chord_down_at_[1]) >= kChordHeld;
        is_chord_due_ = is_chord_due_ || is_chord_told_;
    };
    for (const ButtonEdge& edge : edges) {
        if (!is_of_chord(edge.button)) continue;
        tell_if_due(edge.at);
        auto& down_at = chord_down_at_[edge.button == kChord[0] ? 0 : 1];
        down_at = edge.motion == Motion::Down ? std::optional{edge.at} : std::nullopt;
        is_chord_told_ = is_chord_told_ && is_chord_held();
    }
    tell_if_due(now);
}

void Panel::keep_chord_from(std::vector<ButtonEdge>& heard, Instant now) {
    // The Up of a button that already counts as let go is no news.
    std::erase_if(heard, [&](const ButtonEdge& edge) {
        if (!is_of_chord(edge.button)) return false;
        const bool is_down = edge.motion == Motion::Down;
        const bool was_down = std::exchange(is_heard_down_[index_of(edge.button)], is_down);
        return !is_down && !was_down;
    });
    if (!is_chord_held()) return;
    for (const Button button : kChord)
        if (std::exchange(is_heard_down_[index_of(button)], false)) heard.push_back({button, Motion::Up, now});
}

bool Panel::is_chord_held() const { return chord_down_at_[0] && chord_down_at_[1]; }

bool Panel::take_chord() { return std::exchange(is_chord_due_, false); }

void Panel::light(firmware_io::Lamps lamps, Instant now) {
    for (const Button button : firmware_io::kButtons) {
        LampPattern& lamp = lamps[index_of(button)];
        const Instant since = now - pressed_at_[index_of(button)];
        if (since < Instant{0} || since >= kWink) continue;
        lamp = lamp == LampPattern::Off ? LampPattern::Steady : LampPattern::Off;
    }
    buttons_.set_lamps(lamps);
}

void Panel::tell() {
    if (const auto status = buttons_.status(); status != status_) {
        status_ = status;
        if (status.presence == firmware_io::Presence::Absent)
            base::log::warn("buttons: {}", status.reason);
        else if (!status.reason.empty())
            base::log::info("buttons: {}", status.reason);
    }
    for (const firmware_io::FindingChange& change : health_.take_changes()) {
        const std::string what = describe(change.finding, change.at);
        const bool has_ended = change.turn == firmware_io::Turn::Ended;
        if (is_everyday(change.finding.ailment))
            base::log::debug("buttons: {}{}", what, has_ended ? ", no longer" : "");
        else if (has_ended)
            base::log::info("buttons: {}, no longer", what);
        else
            base::log::warn("buttons: {}", what);
    }
}

}  // namespace quadrat::staff
