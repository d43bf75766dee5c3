// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kiosk/passage.hpp"
#include "kiosk/run_loop.hpp"

namespace quadrat::kiosk {

// Brings what has grown to the GPU, and tells the show when it is there.
class Delivery {
  public:
    // All are borrowed.
    Delivery(const RunLoopParts& parts, const Passage& passage, stage::Theatre& theatre)
        : parts_(parts), passage_(passage), theatre_(theatre) {}

    // Once a frame. True: somebody waits for what is brought.
    bool look(base::Instant now);

  private:
    void bring(base::DisplayTime until, bool is_all, base::Instant now);
    void show(base::DisplayTime until, base::Instant now);

    const RunLoopParts& parts_;
    const Passage& passage_;
    stage::Theatre& theatre_;
    bool has_given_back_ = false;  // what the first landscapes took, once they were there
};

}  // namespace quadrat::kiosk
