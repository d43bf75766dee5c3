// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "display/kms/screen_hardware.hpp"
#include "tempo/flight_log.hpp"

namespace quadrat::display {

// Drives the pure state machine over real or scripted hardware: tells it what happens, does what it says.
class ScreenKeeper {
  public:
    explicit ScreenKeeper(ScreenHardware& hardware) : hardware_(hardware) {}

    // Takes the news; may set the screen up, switch it off or lose it. Between frames only.
    void attend();
    // Hands over the frame that was drawn, not before `how` says. With a screen it waits for it to be shown, 2 s at
    // most, or, drawing ahead, for the frame before it; without one it waits a tenth of a second for news, so that the
    // show goes on slowly and costs nothing.
    Presented present(const tempo::HandOver& how = {});
    void set_power(Power power) { feed(event::PowerAsked{power}); }
    const ScreenState& state() const { return state_; }

  private:
    void feed(ScreenEvent event);
    void perform(const ScreenAction& action);
    void take_news(Instant at_most);
    void wait_for_flip();
    void wait_until(base::DisplayTime at);
    void show_frame(const tempo::HandOver& how);
    Presented told();

    ScreenHardware& hardware_;
    ScreenState state_;
    tempo::FlightLog flights_;
    std::vector<ScreenEvent> queue_;
    bool is_feeding_ = false;
    std::uint64_t frame_ = 0;
    std::uint64_t handed_over_ = 0;  // the last frame that was
    std::uint64_t shown_frame_ = 0;
    Instant shown_at_{0};
};

}  // namespace quadrat::display
