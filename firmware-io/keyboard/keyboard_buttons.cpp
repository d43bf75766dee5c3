// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/keyboard/keyboard_buttons.hpp"

#include <algorithm>

namespace quadrat::firmware_io::keyboard {
namespace {

char upper(char key) { return key >= 'a' && key <= 'z' ? static_cast<char>(key - 'a' + 'A') : key; }

}  // namespace

std::optional<Button> button_for_key(char key) {
    key = upper(key);
    if (key >= 'A' && key <= 'D') return kButtons[static_cast<std::size_t>(key - 'A')];
    if (key >= '1' && key <= '4') return kButtons[static_cast<std::size_t>(key - '1')];
    if (key == kEscape || key == kBackspace || key == kArrowLeft) return Button::Back;
    return std::nullopt;
}

void KeyboardButtons::key(char key, Motion motion, Instant at) {
    if (button_for_key(key)) strokes_.push_back({upper(key), motion, at, false});
}

void KeyboardButtons::lost_focus(Instant at) { strokes_.push_back({0, Motion::Up, at, true}); }

void KeyboardButtons::play(const Stroke& stroke) {
    if (stroke.is_focus_lost) {
        is_held_.fill(false);
        debouncer_.lost(stroke.at);
        return;
    }
    is_held_[static_cast<unsigned char>(stroke.key)] = stroke.motion == Motion::Down;
    const Button button = *button_for_key(stroke.key);
    bool is_closed = false;
    for (std::size_t key = 0; key < is_held_.size(); ++key)
        is_closed = is_closed || (is_held_[key] && button_for_key(static_cast<char>(key)) == button);
    debouncer_.contact(button, is_closed, stroke.at);
}

std::vector<ButtonEdge> KeyboardButtons::poll(Instant now) {
    std::stable_sort(strokes_.begin(), strokes_.end(), [](const Stroke& a, const Stroke& b) { return a.at < b.at; });
    const auto due = std::find_if(strokes_.begin(), strokes_.end(), [&](const Stroke& s) { return s.at > now; });
    std::for_each(strokes_.begin(), due, [&](const Stroke& stroke) { play(stroke); });
    strokes_.erase(strokes_.begin(), due);
    return debouncer_.take(now);
}

std::optional<Instant> KeyboardButtons::next_event_at() const {
    std::optional<Instant> next = debouncer_.next_event_at();
    for (const Stroke& stroke : strokes_) next = next ? std::min(*next, stroke.at) : stroke.at;
    return next;
}

}  // namespace quadrat::firmware_io::keyboard
