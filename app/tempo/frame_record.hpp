// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <cstdint>
#include <optional>

#include "base/display_time.hpp"

namespace quadrat::tempo {

using base::DisplayTime;
using std::chrono::nanoseconds;

// What a frame that is ready is handed to the display with.
struct HandOver {
    DisplayTime begun{};                 // when what had been pressed was read for it
    DisplayTime drawing_since{};         // uploads were over
    std::optional<DisplayTime> drawn{};  // nothing: it was not waited for to the end
    int meant_periods = 1;               // refresh periods of the display that it is meant to take
    std::optional<DisplayTime> not_before{};
    // Wait: present() returns when this frame is shown, so the next one shows what was pressed meanwhile. Ahead: when
    // the frame before it is, so drawing has a frame more time and a press is seen a frame later.
    enum class Then { Wait, Ahead } then = Then::Wait;
};

// What became of one frame. Everybody who judges frames (tempo, health, bench) reads these records.
struct FrameRecord {
    std::uint64_t number = 0;  // counts calls of present(), from 1
    DisplayTime begun{};
    DisplayTime drawing_since{};
    std::optional<DisplayTime> drawn{};
    DisplayTime handed_over{};
    DisplayTime shown{};
    std::optional<DisplayTime> shown_before{};  // the frame before it; nothing: none, or the screen was away since
    nanoseconds period{0};                      // the display's refresh period; 0: it shows frames as they come
    int meant_periods = 1;
};

// From the frame before it to this one; 0 where none was shown before.
nanoseconds took(const FrameRecord& record);

// How long a frame is meant to be shown; 0 where the display has no period.
nanoseconds frame_time(const FrameRecord& record);

// The one definition: it came more than half a refresh period later than it was meant to. Never, where the display has
// no period or no frame was shown before. The governor judges frames of a display without a period as if that were
// 16.7 ms (Tempo::judge).
bool is_late(const FrameRecord& record);
bool is_late(nanoseconds took, nanoseconds period, int meant_periods);

}  // namespace quadrat::tempo
