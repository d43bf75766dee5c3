// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <optional>

#include "base/clock.hpp"

namespace quadrat::kiosk {

// How time passes from one frame to the next. The one place that asks what kind of clock it is.
class Passage {
  public:
    virtual ~Passage() = default;

    // Nothing that happens hangs on how fast the machine is: all that grows is waited for, nobody can listen, and no
    // frame comes late.
    virtual bool waits_for_all() const = 0;
    // After a frame: rests for so long, or goes to the next moment at which something happens by itself.
    virtual void pass(base::Instant now, std::optional<base::Instant> next_moment, base::Instant rest) = 0;
};

std::unique_ptr<Passage> passage_of(base::Clock& clock);  // borrowed

}  // namespace quadrat::kiosk
