// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/scripted/script.hpp"

#include <algorithm>

namespace quadrat::firmware_io::scripted {
namespace {

constexpr Instant kLongest = std::chrono::hours{10'000};

std::size_t index_of(Button button) { return static_cast<std::size_t>(button); }

}  // namespace

void ScriptWriter::add(ScriptEvent event) {
    if (events_.size() == kMostEvents)
        throw ScriptError{"the script has more than " + std::to_string(kMostEvents) +
                          " events; cut it in two or use fewer bounce edges"};
    end_ = std::max(end_, event.at);
    events_.push_back(event);
}

void ScriptWriter::begin_action() {
    if (cursor_ > kLongest) throw ScriptError{"the script is longer than 10000 hours; shorten the waits"};
    last_action_ = cursor_;
}

ScriptWriter& ScriptWriter::at(Instant moment) {
    if (moment < last_action_) throw ScriptError{"the time lies before the action above; write the actions in order"};
    cursor_ = moment;
    return *this;
}

ScriptWriter& ScriptWriter::wait(Instant span) {
    cursor_ += span;
    begin_action();
    end_ = std::max(end_, cursor_);
    return *this;
}

void ScriptWriter::close(Button button, Instant from, Instant until) {
    Instant& free_from = free_from_[index_of(button)];
    if (free_from > from)
        throw ScriptError{"button " + std::string{name_of(button)} + " is still held; release it first or press later"};
    add({from, Happening::Close, button});
    if (until != Instant::max()) add({until, Happening::Open, button});
    free_from = until;
}

ScriptWriter& ScriptWriter::hold(Button button, Instant span) { return chord({button}, span); }

ScriptWriter& ScriptWriter::hold(Button button) {
    begin_action();
    close(button, cursor_, Instant::max());
    return *this;
}

ScriptWriter& ScriptWriter::chord(const std::vector<Button>& buttons, Instant span) {
    begin_action();
    for (const Button button : buttons) close(button, cursor_, cursor_ + span);
    cursor_ += span;
    return *this;
}

ScriptWriter& ScriptWriter::bounce(Button button, std::size_t edges, Instant span) {
    begin_action();
    for (std::size_t i = 0; i + 1 < edges; i += 2) {
        const auto moment = [&](std::size_t edge) {
            return cursor_ + span / static_cast<Instant::rep>(edges) * static_cast<Instant::rep>(edge);
        };
        close(button, moment(i), moment(i + 1));
    }
    cursor_ += span;
    close(button, cursor_, cursor_ + kCleanPress);
    cursor_ += kCleanPress;
    return *this;
}

ScriptWriter& ScriptWriter::release(Button button) {
    begin_action();
    if (free_from_[index_of(button)] != Instant::max())
        throw ScriptError{"button " + std::string{name_of(button)} + " is not held; write \"hold " +
                          std::string{name_of(button)} + "\" before"};
    add({cursor_, Happening::Open, button});
    free_from_[index_of(button)] = cursor_;
    return *this;
}

ScriptWriter& ScriptWriter::release() {
    for (const Button button : kButtons)
        if (free_from_[index_of(button)] == Instant::max()) release(button);
    return *this;
}

ScriptWriter& ScriptWriter::unplug() {
    begin_action();
    if (!is_plugged_) throw ScriptError{"the device is unplugged already; write \"plug\" before"};
    is_plugged_ = false;
    add({cursor_, Happening::Unplug});
    return *this;
}

ScriptWriter& ScriptWriter::plug() {
    begin_action();
    if (is_plugged_) throw ScriptError{"the device is plugged in already; write \"unplug\" before"};
    is_plugged_ = true;
    add({cursor_, Happening::Plug});
    return *this;
}

Script ScriptWriter::script() const {
    Script script{events_, end_};
    std::stable_sort(script.events.begin(), script.events.end(),
                     [](const ScriptEvent& a, const ScriptEvent& b) { return a.at < b.at; });
    return script;
}

}  // namespace quadrat::firmware_io::scripted
