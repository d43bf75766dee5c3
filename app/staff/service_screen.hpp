// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "firmware-io/button_press.hpp"
#include "firmware-io/lamps.hpp"
#include "staff/vitals.hpp"
#include "stage/board.hpp"

namespace quadrat::staff {

// How it draws just now, for whoever develops: frames, detail, triangles, GPU.
stage::Board figures_board(const Vitals& vitals, bool has_wires);

// Each lamp in turn, then all of them.
firmware_io::Lamps lamp_test(firmware_io::Instant now);

enum class StaffWish { Picture, Restart, ShutDown };

// What staff see after the chord, and what they can do there: A tests the lamps, B restarts the exhibit, C takes a
// picture, D shuts the machine down (B and D ask once more), Back leaves. It leaves by itself when nobody presses.
class ServiceScreen {
  public:
    using Instant = firmware_io::Instant;
    static constexpr Instant kPatience = std::chrono::minutes{2};
    static constexpr Instant kSureWithin = std::chrono::seconds{5};

    void open(Instant now);
    bool is_open(Instant now);

    std::optional<StaffWish> press(firmware_io::Button button, Instant now);

    bool is_testing_lamps() const { return is_testing_lamps_; }
    firmware_io::Lamps lamps(Instant now) const;

    stage::Board board(const Vitals& vitals, Instant now) const;

  private:
    bool is_sure(firmware_io::Button button, Instant now) const;

    bool is_open_ = false;
    bool is_testing_lamps_ = false;
    Instant last_press_{0};
    std::optional<firmware_io::Button> asked_;  // a press that wants to be said twice
    std::string told_;                          // what came of the last press
};

}  // namespace quadrat::staff
