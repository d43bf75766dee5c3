// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "switches/switches.hpp"

namespace quadrat::kiosk {

// How long a visit waits for everything: as the site says, and so many times longer for who needs it.
class Pace {
  public:
    explicit Pace(const exhibit::Timings& usual) : usual_(usual), now_(usual) {}

    const exhibit::Timings& now() const { return now_; }
    void wait_longer(double times) {
        times_ = times;
        now_ = switches::patient(usual_, times_);
    }
    // Where there is something to breed on from, and the site has it so.
    void allow_breeding_on(bool is_there) { now_.can_breed_on = usual_.can_breed_on && is_there; }
    // What the site has changed. How questions are asked stays as it was at the start, and so does whether words are.
    void follow(exhibit::Timings usual, bool has_words) {
        usual.asking = usual_.asking;
        usual.sliders = usual_.sliders;
        if (!has_words) usual.describe_words = 0;
        usual_ = usual;
        wait_longer(times_);
    }

  private:
    exhibit::Timings usual_;
    exhibit::Timings now_;
    double times_ = 1;
};

}  // namespace quadrat::kiosk
