// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "firmware-io/button_health.hpp"
#include "firmware-io/button_source.hpp"

namespace quadrat::staff {

// The buttons as the exhibit hears them: what their source gives, less what a faulty button would do to a visit, and
// less the staff's chord. Logs what changes, once.
class Panel {
  public:
    // Staff press these two together for so long.
    static constexpr firmware_io::Button kChord[2] = {firmware_io::Button::A, firmware_io::Button::Back};
    static constexpr firmware_io::Instant kChordHeld = std::chrono::seconds{5};

    explicit Panel(firmware_io::ButtonSource& buttons, firmware_io::HealthMemory memory = {});

    // The edges since the last call that a visit should hear, in order. While both buttons of the chord are down, both
    // count as let go.
    std::vector<firmware_io::ButtonEdge> poll(firmware_io::Instant now);

    // Whether the chord has just been held long enough; true once for each time it is held.
    bool take_chord();

    // Lit until further notice. The lamp of a button that was just pressed winks, so that whoever pressed it knows.
    void light(firmware_io::Lamps lamps, firmware_io::Instant now);

    const firmware_io::ButtonHealth& health() const { return health_; }
    const firmware_io::SourceStatus& status() const { return status_; }
    const firmware_io::Contacts& contacts() const { return buttons_.contacts(); }
    std::uint64_t presses() const { return presses_; }  // that were heard
    // Of each button, in the order of kButtons.
    const std::array<std::uint64_t, firmware_io::kButtons.size()>& presses_of() const { return presses_of_; }

  private:
    void time_chord(const std::vector<firmware_io::ButtonEdge>& edges, firmware_io::Instant now);
    void keep_chord_from(std::vector<firmware_io::ButtonEdge>& heard, firmware_io::Instant now);
    bool is_chord_held() const;
    void tell();

    firmware_io::ButtonSource& buttons_;
    firmware_io::ButtonHealth health_;
    firmware_io::SourceStatus status_;
    std::array<firmware_io::Instant, firmware_io::kButtons.size()> pressed_at_;
    std::array<bool, firmware_io::kButtons.size()> is_heard_down_{};
    std::array<std::optional<firmware_io::Instant>, 2> chord_down_at_;  // of kChord's buttons that are down
    bool is_chord_told_ = false;
    bool is_chord_due_ = false;
    std::uint64_t presses_ = 0;
    std::array<std::uint64_t, firmware_io::kButtons.size()> presses_of_{};
};

// What a panel remembers across a power cut, as one line of text; what is not of that form is as good as nothing.
std::string to_text(const firmware_io::HealthMemory& memory);
firmware_io::HealthMemory health_memory_from(const std::string& text);

// One line for the log and for staff: "button B is stuck (held since 61 s)".
std::string describe(const firmware_io::Finding& finding, firmware_io::Instant now);

}  // namespace quadrat::staff
