// SPDX-License-Identifier: Apache-2.0
#include "tempo/flight_log.hpp"

#include <utility>

namespace quadrat::tempo {

void FlightLog::handed_over(std::uint64_t number, const HandOver& how, DisplayTime at) {
    in_flight_ = FrameRecord{};
    in_flight_->number = number;
    in_flight_->begun = how.begun;
    in_flight_->drawing_since = how.drawing_since;
    in_flight_->drawn = how.drawn;
    in_flight_->handed_over = at;
    in_flight_->meant_periods = how.meant_periods;
}

void FlightLog::shown(DisplayTime at, nanoseconds period) {
    if (!in_flight_) return;
    in_flight_->shown = at;
    in_flight_->shown_before = std::exchange(last_shown_, at);
    in_flight_->period = period;
    finished_.push_back(*std::exchange(in_flight_, std::nullopt));
}

void FlightLog::interrupted() {
    in_flight_.reset();
    last_shown_.reset();
}

std::optional<DisplayTime> FlightLog::in_flight_since() const {
    if (!in_flight_) return std::nullopt;
    return in_flight_->handed_over;
}

std::vector<FrameRecord> FlightLog::take_finished() { return std::exchange(finished_, {}); }

}  // namespace quadrat::tempo
