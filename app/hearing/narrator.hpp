// SPDX-License-Identifier: Apache-2.0
// The room `hearing`: what the audience hears, as `stage` is what it sees. What is said and sounded of a visit, and who
// plays it. How anything sounds is below it, in `sound`.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/clock.hpp"
#include "exhibit/visit.hpp"
#include "genome/words.hpp"
#include "site/configuration.hpp"
#include "sound/mixer.hpp"
#include "sound/speaker.hpp"

namespace quadrat::hearing {

// What there is to hear of a visit at a moment.
struct Subject {
    const exhibit::State& visit;
    base::Instant now{0};
    std::string language = {};  // that is spoken
    std::string prompt = {};    // a key of genome::kPrompts: what is asked
    // What the four are called, in Ask; nothing where a genome has no words.
    std::array<std::optional<genome::Description>, 4> four = {};
    std::array<std::string, 4> labels = {};           // of the buttons, in Describe, Slide and Language; "": none
    std::array<std::string, 4> label_languages = {};  // each in its own; "": the one that is spoken
    std::string caption = {};                         // of Breed and Finale
    std::optional<exhibit::Choice> pressed = {};      // last
    base::Instant pressed_at{0};
    bool is_marking = false;  // with one button or two
    std::optional<exhibit::Choice> marked = {};
    std::string hint = {};  // a key of genome::kPrompts: how that is done; "": none
};

// The key of genome::kPrompts that asks this; "" where another tells.
std::string key_of(exhibit::Prompt prompt);

struct Says {
    sound::Utterance utterance;
    std::optional<exhibit::Choice> of = {};  // the choice that it describes
};
struct Hushes {};  // what is being said is not said any more, nor what was to come
using Cue = std::variant<sound::Sounds, Says, Hushes>;

// Tells a visit to who cannot see it: signals for what happens, the question, each choice in words. Knows no clock and
// no card; how long words take is reckoned.
class Narrator {
  public:
    // Borrowed: the site's own words.
    explicit Narrator(const site::Configuration& configuration) : configuration_(configuration) {}

    // Once a frame. What is to be heard from now on, in order.
    std::vector<Cue> look(const Subject& subject);
    // The question and its choices once more.
    std::vector<Cue> repeat(const Subject& subject);
    std::vector<Cue> hush(base::Instant now);

    base::Instant speaks_until() const { return speaks_until_; }
    // Which choice is being described, 0 to 3.
    std::optional<std::size_t> described(base::Instant now) const;

  private:
    using Cues = std::vector<Cue>;
    void tell_screen(const Subject& subject, Cues& cues);
    void forget_visit();
    void say_choices(const Subject& subject, Cues& cues);
    void ask(const Subject& subject, Cues& cues);
    void tell_press(const Subject& subject, Cues& cues);
    void tell_mark(const Subject& subject, Cues& cues);
    void say(const std::string& key, const Subject& subject, Cues& cues);
    void say_choice(exhibit::Choice choice, const Subject& subject, Cues& cues);
    void say(Says what, base::Instant now, Cues& cues);
    void be_silent(base::Instant now, Cues& cues);

    const site::Configuration& configuration_;
    struct Described {
        base::Instant from, until;
        exhibit::Choice choice;
    };
    std::vector<Described> described_;
    base::Instant speaks_until_{0};
    bool has_said_ = false;  // anything, since it was hushed
    exhibit::Screen screen_ = exhibit::Screen::Attract;
    bool had_asked_ = false;  // that screen
    base::Instant since_{0};
    int rounds_ = 0;
    int slider_ = 0;
    base::Instant pressed_at_{-1};
    std::optional<exhibit::Choice> marked_;
    base::Instant marked_in_{-1};
    base::Instant asked_in_{-1};  // the question in which something has been marked
    bool knows_how_ = false;      // was told in this visit how to hear it again
    std::string hint_;
};

}  // namespace quadrat::hearing
