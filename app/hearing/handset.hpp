// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <optional>
#include <vector>

#include "exhibit/visit.hpp"

namespace quadrat::hearing {

// Back, where the exhibit speaks: pressed shortly it is Back; held for a second it says everything again, or is silent
// where it was speaking; held on, each second and a half it is louder, and after the loudest the quietest. So what is
// pressed is known when the button is let go: until then the visit hears nothing of it.
class Handset {
  public:
    enum class Wish { Repeat, Louder };
    static constexpr std::chrono::milliseconds kRepeatAfter{1'000};
    static constexpr std::chrono::milliseconds kLouderEvery{1'500};

    void press(exhibit::Instant now);
    bool is_held() const { return since_.has_value(); }
    // True: it was a short one, and is Back.
    bool release(exhibit::Instant now);
    // Nothing is held any more, and nothing was pressed.
    void let_go() { since_.reset(); }
    // Once a frame.
    std::optional<Wish> look(exhibit::Instant now);
    std::optional<exhibit::Instant> next_deadline() const;

  private:
    std::optional<exhibit::Instant> since_;
    int wishes_ = 0;  // while it has been held
};

}  // namespace quadrat::hearing
