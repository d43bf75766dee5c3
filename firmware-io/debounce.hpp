// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <vector>

#include "firmware-io/button_source.hpp"

namespace quadrat::firmware_io {

// FirstEdge: Down at the first closing, at once; Up when the contact has stayed open for the whole period. The quickest
// that cannot double a press whose bounces are closer together than the period.
// Integrator: a charge in [0, period] that rises while the contact is closed and falls while it is open; Down when it
// is full, Up when it is empty. A period later, but single spikes from a long cable are no press.
enum class DebounceForm { FirstEdge, Integrator };

struct DebounceOptions {
    DebounceForm form = DebounceForm::FirstEdge;
    Instant period = std::chrono::milliseconds{5};  // 0 lets every edge through
};

// Turns what contacts do into what people did. Pure: the same calls give the same edges.
class Debouncer {
  public:
    explicit Debouncer(DebounceOptions options = {});

    // The contact of a button closed or opened. Times of one button do not go backwards and are no earlier than the
    // last take(); a moment that would be is taken as the earliest that is allowed. Saying the same again is no edge.
    void contact(Button button, bool is_closed, Instant at);

    // The contact as it is found when a device appears. A closed one stays without effect until it has been open.
    void found(Button button, bool is_closed, Instant at);

    // The device vanished: what was down goes up, and every contact counts as open.
    void lost(Instant at);

    // The settled edges up to `now`, in order.
    std::vector<ButtonEdge> take(Instant now);

    // When the next edge settles if no contact moves.
    std::optional<Instant> next_event_at() const;

    const Contacts& contacts() const { return contacts_; }

  private:
    struct Charge {
        bool is_armed = true;  // false: found closed, and not yet seen open
        Instant raw_since{0};
        Instant level{0};     // of the integrator, in [0, period]
        Instant level_at{0};  // when `level` was true
    };
    std::optional<Instant> settles_at(std::size_t i) const;
    void settle(std::size_t i, Instant until);
    void set_raw(std::size_t i, bool is_closed, Instant at);

    DebounceOptions options_;
    Contacts contacts_;
    std::array<Charge, kButtons.size()> charges_;
    std::vector<ButtonEdge> settled_;
    Instant taken_until_;
};

}  // namespace quadrat::firmware_io
