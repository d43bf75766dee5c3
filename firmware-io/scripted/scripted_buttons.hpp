// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "firmware-io/button_source.hpp"
#include "firmware-io/debounce.hpp"
#include "firmware-io/scripted/script.hpp"

namespace quadrat::firmware_io::scripted {

// Plays a script: its raw edges go through the same debouncing as those of hardware.
class ScriptedButtons final : public ButtonSource {
  public:
    explicit ScriptedButtons(Script script, DebounceOptions debounce = {});

    std::vector<ButtonEdge> poll(Instant now) override;
    SourceStatus status() const override;
    const Contacts& contacts() const override { return debouncer_.contacts(); }
    std::optional<Instant> next_event_at() const override;
    // The last event and the script's own end have passed, and every edge has settled.
    bool is_finished() const override;

  private:
    void play(const ScriptEvent& event);

    Script script_;
    Debouncer debouncer_;
    std::size_t next_ = 0;
    std::array<bool, kButtons.size()> is_closed_{};  // by the visitor's hand, plugged in or not
    bool is_plugged_ = true;
    Instant now_;
};

// Reads as base::read_text does, and parses. Throws ScriptError, naming the file, if it cannot be read or is larger
// than 8 MB.
Script read_script(const std::filesystem::path& file);

}  // namespace quadrat::firmware_io::scripted
