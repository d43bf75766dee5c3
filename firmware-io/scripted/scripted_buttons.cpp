// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/scripted/scripted_buttons.hpp"

#include <algorithm>
#include <utility>

#include "firmware-io/text_file.hpp"

namespace quadrat::firmware_io::scripted {

ScriptedButtons::ScriptedButtons(Script script, DebounceOptions debounce)
    : script_{std::move(script)}, debouncer_{debounce}, now_{Instant::min()} {}

void ScriptedButtons::play(const ScriptEvent& event) {
    switch (event.happening) {
        case Happening::Close:
        case Happening::Open: {
            const bool is_closed = event.happening == Happening::Close;
            is_closed_[index_of(event.button)] = is_closed;
            if (is_plugged_) debouncer_.contact(event.button, is_closed, event.at);
            break;
        }
        case Happening::Unplug:
            is_plugged_ = false;
            debouncer_.lost(event.at);
            break;
        case Happening::Plug:
            is_plugged_ = true;
            for (const Button button : kButtons) debouncer_.found(button, is_closed_[index_of(button)], event.at);
            break;
    }
}

std::vector<ButtonEdge> ScriptedButtons::poll(Instant now) {
    now_ = std::max(now_, now);
    for (; next_ < script_.events.size() && script_.events[next_].at <= now_; ++next_) play(script_.events[next_]);
    return debouncer_.take(now_);
}

SourceStatus ScriptedButtons::status() const {
    if (is_plugged_) return {};
    return {Presence::Absent, "the script has unplugged its buttons; it says \"plug\" when they return"};
}

std::optional<Instant> ScriptedButtons::next_event_at() const {
    std::optional<Instant> next = debouncer_.next_event_at();
    const auto sooner = [&](Instant at) { next = next ? std::min(*next, at) : at; };
    if (next_ < script_.events.size())
        sooner(script_.events[next_].at);
    else if (now_ < script_.end)
        sooner(script_.end);
    return next;
}

bool ScriptedButtons::is_finished() const { return !next_event_at(); }

Script read_script(const std::filesystem::path& file) {
    constexpr std::size_t kLargest = 8u << 20;
    std::string text;
    try {
        text = read_text(file, kLargest);
    } catch (const TextError& error) {
        throw ScriptError{error.what()};
    }
    return parse_script(text, file.string());
}

}  // namespace quadrat::firmware_io::scripted
