// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <deque>

#include "firmware-io/button_source.hpp"

namespace quadrat::firmware_io {

enum class Ailment {
    LeanedOn,         // held longer than anyone presses: a bag, an elbow
    Stuck,            // held so long that it will not come up by itself
    Chattering,       // opens and closes faster than a hand can
    Dead,             // never pressed while the others are
    PressedTogether,  // two of A to D at once
    AllPressed,       // all of A to D at once
};
inline constexpr std::array kAilments{Ailment::LeanedOn, Ailment::Stuck,           Ailment::Chattering,
                                      Ailment::Dead,     Ailment::PressedTogether, Ailment::AllPressed};
std::string_view name_of(Ailment ailment);  // "stuck", "pressed together", …

struct HealthLimits {
    Instant leaned_on_after = std::chrono::seconds{10};
    Instant stuck_after = std::chrono::seconds{60};
    // A hand reaches 14 presses a second. Either of these is no hand: edges before debouncing, or presses after it.
    unsigned chatter_edges_per_s = 300;
    unsigned chatter_presses = 5;
    Instant chatter_window = std::chrono::milliseconds{250};
    // A masked button is heard again when it has been up and quiet for so long.
    Instant recovers_after = std::chrono::seconds{3};
    // In time that the exhibit ran: a week of eight hours a day. And how often the others were pressed meanwhile.
    Instant dead_after = std::chrono::hours{7 * 8};
    std::uint64_t dead_after_presses = 100;
};

// Something that is the matter now. Of PressedTogether and AllPressed the button is the one that was pressed last.
struct Finding {
    Ailment ailment;
    Button button;
    Instant since;
    friend bool operator==(const Finding&, const Finding&) = default;
};
enum class Turn { Began, Ended };
struct FindingChange {
    Turn turn;
    Finding finding;
    Instant at;
};

// How often each ailment of each button began, ever.
using AilmentCounts = std::array<std::array<std::uint64_t, kButtons.size()>, kAilments.size()>;

// What must outlive the evening's power cut for a dead button to be noticed: the owner stores it and hands it back.
struct HealthMemory {
    std::array<Instant, kButtons.size()> unpressed_for{};         // running time since its last press
    std::array<std::uint64_t, kButtons.size()> others_pressed{};  // presses of other buttons since then
    friend bool operator==(const HealthMemory&, const HealthMemory&) = default;
};

// Watches the buttons of a source and keeps a faulty one from taking the visit with it: a stuck or chattering button is
// masked, which gives an Up for a Down that was heard, and is heard again once it has recovered. The other ailments are
// only reported. Pure but for what it remembers; a button that was never pressed counts from the start.
class ButtonHealth {
  public:
    explicit ButtonHealth(HealthLimits limits = {}, HealthMemory memory = {});

    // To be called after each poll, with what it gave: returns what the exhibit should hear, in order.
    std::vector<ButtonEdge> hear(const std::vector<ButtonEdge>& edges, const Contacts& contacts, Instant now);

    const std::vector<Finding>& findings() const { return findings_; }  // what is the matter now, oldest first
    std::vector<FindingChange> take_changes();                          // since the last call
    bool is_masked(Button button) const { return watches_[index_of(button)].is_masked; }
    const AilmentCounts& counts() const { return counts_; }
    const HealthMemory& memory() const { return memory_; }

  private:
    struct Sample {
        Instant at;
        std::uint64_t raw_edges;
    };
    struct Watch {
        bool is_masked = false;
        bool is_heard_down = false;
        Instant quiet_since{0};       // while masked: up, and few edges
        std::deque<Sample> samples;   // of the last second, and one before it
        std::deque<Instant> presses;  // the last few
    };
    void note(Ailment ailment, Button button, bool is_present, Instant since, Instant now);
    void remember_press(Button pressed);
    void observe(Button button, const Contact& contact, Instant now);
    bool is_chattering(Watch& watch, const Contact& contact, Instant now) const;
    void observe_together(const Contacts& contacts, Instant now);
    void observe_dead(Button button, Instant now);
    bool has(Ailment ailment, Button button) const;

    HealthLimits limits_;
    HealthMemory memory_;
    std::array<Watch, kButtons.size()> watches_;
    std::vector<Finding> findings_;
    std::vector<FindingChange> changes_;
    AilmentCounts counts_{};
    Button last_pressed_ = Button::A;
    std::optional<Instant> heard_at_;
};

}  // namespace quadrat::firmware_io
