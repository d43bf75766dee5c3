// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <chrono>

namespace quadrat::fleet {

// How long to wait before a connection is tried again: twice as long each time, until one has lasted. A broker that
// lets somebody in and throws them out at once is as busy as one that refuses.
class BackOff {
  public:
    using Moment = std::chrono::steady_clock::time_point;
    static constexpr std::chrono::seconds kFirst{1};
    static constexpr std::chrono::seconds kLongest{60};
    // Longer than the longest wait: else of two that throw each other out, each stays in for just so long as the other
    // waits, and both begin anew.
    static constexpr std::chrono::seconds kLasting{180};

    Moment next_try() const { return next_; }
    void tried(Moment now) {
        wait_ = patience_;
        next_ = now + wait_;
        patience_ = std::min(2 * patience_, kLongest);
    }
    // The wait begins when the connection is lost, not when it was made.
    void lost(Moment now) { next_ = now + wait_; }
    // To be told while it is connected, since then. True: it has just lasted long enough.
    bool stands(Moment since, Moment now) {
        if (patience_ == kFirst || now - since < kLasting) return false;
        patience_ = wait_ = kFirst;
        return true;
    }

  private:
    std::chrono::seconds patience_ = kFirst;
    std::chrono::seconds wait_ = kFirst;  // after the last try
    Moment next_{};
};

}  // namespace quadrat::fleet
