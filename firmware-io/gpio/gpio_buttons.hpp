// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "firmware-io/button_source.hpp"
#include "firmware-io/debounce.hpp"
#include "firmware-io/gpio/find_line.hpp"
#include "firmware-io/gpio/kernel_clock.hpp"

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

// Buttons and lamps on GPIO lines. If anything of the wiring is missing the whole panel is Absent, so that nobody
// wonders why three of four work; it is tried again every second. Edges carry the kernel's timestamps.
class GpioButtons final : public ButtonSource {
  public:
    GpioButtons(std::unique_ptr<GpioHost> host, Wiring wiring);

    std::vector<ButtonEdge> poll(Instant now) override;
    SourceStatus status() const override { return status_; }
    const Contacts& contacts() const override { return debouncer_.contacts(); }
    void set_lamps(const Lamps& lamps) override { patterns_ = lamps; }
    std::optional<Instant> next_event_at() const override { return debouncer_.next_event_at(); }

  private:
    struct Bank {  // what one chip contributes
        std::unique_ptr<InputLines> inputs;
        std::vector<Button> buttons;
        std::unique_ptr<OutputLines> outputs;
        std::vector<Button> lamps;
    };
    void open(Instant now);
    void lose(Instant now, std::string reason);
    std::vector<Bank> request(const std::vector<ChipFacts>& chips);
    bool read_edges(Instant now);
    enum class Levels { AfterGap, AtOpening };
    bool read_levels(Levels when, Instant now);
    bool drive_lamps(Instant now);

    std::unique_ptr<GpioHost> host_;
    Wiring wiring_;
    Debouncer debouncer_;
    KernelClock clock_;
    Lamps patterns_{};
    std::vector<std::vector<bool>> lit_;  // what was last written, by bank
    std::vector<Bank> banks_;             // empty while absent
    SourceStatus status_;
    std::optional<Instant> retry_at_;
    Instant levels_read_at_{0};
};

}  // namespace quadrat::firmware_io::gpio
