// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>

namespace quadrat::machine {

// Since this program was executed, to ten milliseconds; zero where the system does not say.
std::chrono::milliseconds since_start();

// Says in the log, once each, how long after its execution the exhibit drew its first frame and its first landscapes.
class StartReport {
  public:
    // After a frame is drawn.
    void drawn(bool has_landscapes);

  private:
    bool is_first_told_ = false;
    bool are_landscapes_told_ = false;
};

}  // namespace quadrat::machine
