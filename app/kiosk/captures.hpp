// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kiosk/run_loop.hpp"

namespace quadrat::kiosk {

// The pictures that a run keeps of what it shows: each act once for the album, and now and then a finale for the times
// when no landscape is there.
class Captures {
  public:
    explicit Captures(const RunLoopParts& parts) : parts_(parts) {}
    // Before the frame is drawn: draws over the canvas where a picture is due.
    void keep(stage::Theatre& theatre, const display::Canvas& canvas, base::Instant now);
    // Words that staff wish to see, likewise: a frame's time, when nobody is there to be kept waiting by it.
    void draw_preview(stage::Theatre& theatre, const display::Canvas& canvas, base::Instant now);
    // After it was drawn. What is asked for from afar comes without a wait; a fault is kept as it was just now.
    void answer(stage::Theatre& theatre);

  private:
    void keep_bred(stage::Theatre& theatre, const display::Canvas& canvas);
    void keep_earlier_landscape(stage::Theatre& theatre, const display::Canvas& canvas, base::Instant now);

    const RunLoopParts& parts_;
    int collected_ = 0;     // the last finale that was
    int photographed_ = 0;  // the last act that was
    int round_ = 1;         // that is or was seen last
    int generations_ = 0;
    int finales_ = 0;
    std::string glimpsed_;  // the file of the picture that is on its way
};

}  // namespace quadrat::kiosk
