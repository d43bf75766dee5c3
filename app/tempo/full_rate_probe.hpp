// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <optional>

// From a frame in several of the screen's periods back to one less: what was too slow may have been too hot, or busy
// with something else.
namespace quadrat::tempo {

// Watches whether all frames of a minute in which landscapes grew, or of ten minutes in which none did, would have been
// ready in one period less, but for one, and one more of each four hundred. Where one would not do after all, it waits
// twice as long before it watches again.
class FullRateProbe {
  public:
    using Instant = std::chrono::nanoseconds;

    // Begins to watch, or goes on. False, and nothing begun: it has been seen a short while ago that one would not do.
    bool watch(Instant now);
    // share_used: when it was drawn, of one period less than it had; 1 and more: all of it.
    void frame(Instant now, float share_used, bool is_growing);
    // One period less would do. Whoever takes it says so, and says when that is over.
    bool is_open(Instant now) const;
    void taken(Instant now);
    void given_up(Instant now);

  private:
    bool is_watching_ = false;
    bool was_growing_ = false;  // while it watched
    int frames_ = 0;
    int without_room_ = 0;
    Instant since_{0};
    Instant not_before_{0};
    std::optional<Instant> taken_at_;
    Instant pause_{std::chrono::minutes{1}};
};

}  // namespace quadrat::tempo
