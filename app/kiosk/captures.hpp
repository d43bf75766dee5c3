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

  private:
    void keep_bred(stage::Theatre& theatre, const display::Canvas& canvas);
    void keep_earlier_landscape(stage::Theatre& theatre, const display::Canvas& canvas, base::Instant now);

    const RunLoopParts& parts_;
    int collected_ = 0;     // the last finale that was
    int photographed_ = 0;  // the last act that was
    int round_ = 1;         // that is or was seen last
    int generations_ = 0;
    int finales_ = 0;
};

}  // namespace quadrat::kiosk
