// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "firmware-io/button_source.hpp"
#include "firmware-io/debounce.hpp"
#include "firmware-io/gpio/find_line.hpp"
#include "firmware-io/kernel_clock.hpp"

namespace quadrat::firmware_io::gpio {

struct Wire {
    Button button;
    LineAddress line;
    friend bool operator==(const Wire&, const Wire&) = default;
};

// A panel as it is wired: a contact from each line to ground by default, and for lit buttons an output to each lamp.
struct Wiring {
    std::vector<Wire> contacts;
    std::vector<Wire> lamps;
    InputOptions inputs;
    DebounceOptions debounce;
};

// Buttons and lamps on GPIO lines. Lines that cannot be had are named in the status and tried again, every second while
// no button has a line (then the panel is Absent), every ten seconds otherwise: the visit goes on with what works.
// Edges carry the kernel's timestamps.
class GpioButtons final : public ButtonSource {
  public:
    GpioButtons(std::unique_ptr<GpioHost> host, Wiring wiring);

    std::vector<ButtonEdge> poll(Instant now) override;
    SourceStatus status() const override { return status_; }
    SourceStatus look() override;  // Absent if any line cannot be had: who mends one mends all
    const Contacts& contacts() const override { return debouncer_.contacts(); }
    void set_lamps(const Lamps& lamps) override;
    std::optional<Instant> next_event_at() const override { return debouncer_.next_event_at(); }

  private:
    struct ContactBank {  // of one chip
        std::unique_ptr<InputLines> lines;
        std::vector<Wire> wires;
    };
    struct LampBank {
        std::unique_ptr<OutputLines> lines;
        std::vector<Wire> wires;
        std::vector<bool> lit;  // as last written
    };
    enum class Levels { AfterGap, AtOpening };

    void open(Instant now);
    void open_contacts(const std::vector<ChipFacts>& chips, Instant now);
    void open_lamps(const std::vector<ChipFacts>& chips);
    void lose(Instant now);
    void describe();
    bool read_edges(Instant now);
    bool read_levels(const ContactBank& bank, Levels when, Instant now);
    bool drive_lamps(Instant now);

    std::unique_ptr<GpioHost> host_;
    Wiring wiring_;
    Debouncer debouncer_;
    KernelClock clock_;
    Lamps patterns_{};
    std::vector<ContactBank> contact_banks_;
    std::vector<LampBank> lamp_banks_;
    std::vector<Wire> missing_contacts_, missing_lamps_;
    std::string trouble_;  // with the last line that could not be had
    SourceStatus status_;
    std::optional<Instant> retry_at_;
    Instant levels_read_at_{0};
    Instant polled_at_{0};
};

}  // namespace quadrat::firmware_io::gpio
