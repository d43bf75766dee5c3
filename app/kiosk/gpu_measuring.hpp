// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "kiosk/run_loop.hpp"
#include "stage/gpu_benchmark.hpp"

namespace quadrat::kiosk {

// Measures a GPU that is not known yet, while nobody is there and nothing grows: some frames come late for it, once.
class GpuMeasuring {
  public:
    explicit GpuMeasuring(const RunLoopParts& parts) : parts_(parts) {}
    // Before the frame is drawn: draws over the canvas where a step is due.
    void step(stage::Theatre& theatre, const display::Canvas& canvas, base::Instant now);
    void has_period(std::chrono::nanoseconds period) { period_ = period; }  // the display's
    // Frames whose time says nothing, because something was tried out in them: counts one.
    bool takes_a_frame() { return frames_disturbed_ > 0 && frames_disturbed_-- > 0; }

  private:
    const RunLoopParts& parts_;
    std::optional<stage::GpuBenchmark> benchmark_;
    std::chrono::nanoseconds period_{16'666'667};
    int frames_disturbed_ = 0;
};

}  // namespace quadrat::kiosk
