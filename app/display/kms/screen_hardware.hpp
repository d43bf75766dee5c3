// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <vector>

#include "display/kms/screen_state.hpp"

namespace quadrat::display {

struct FlipShown {
    Instant at;  // as the kernel reports it, sane or not
};
using News = std::variant<FlipShown, event::PlugMoved, event::CardAppeared, event::CardRemoved>;

// What the screen's keeper asks of cards and cables. The real one is DrmHardware; tests script another.
// Nothing here throws.
class ScreenHardware {
  public:
    virtual ~ScreenHardware() = default;
    virtual Instant now() = 0;
    // Waits for news, at most this long; 0: takes what is there.
    virtual std::vector<News> wait(Instant at_most) = 0;

    virtual ProbeResult probe() = 0;
    virtual std::optional<event::PlugMoved> glance() = 0;
    virtual Refusal modeset(int rung) = 0;  // of the screen that probe found
    virtual void disable() = 0;
    virtual void close_card() = 0;
    // Hands over what was drawn. Refused as Busy it keeps the frame, and the next call offers the same one again.
    // Nothing: the GPU lost its context.
    virtual std::optional<Refusal> flip() = 0;
    virtual Instant period() const = 0;  // of the mode that is set
};

}  // namespace quadrat::display
