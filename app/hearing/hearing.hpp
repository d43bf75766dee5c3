// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <optional>
#include <span>

#include "genome/recipe.hpp"
#include "hearing/concert.hpp"
#include "hearing/handset.hpp"
#include "hearing/narrator.hpp"

namespace quadrat::hearing {

enum class Aloud {
    Played,
    Told,  // in the log alone: on a simulated clock nobody can listen
};

// All that is heard of an exhibit. Where the site has switched sound off it opens nothing and does nothing.
class Hearing {
  public:
    // The configuration is borrowed.
    Hearing(const site::Configuration& configuration, base::Seed seed, Aloud aloud);

    bool is_on() const { return is_on_; }
    bool speaks() const { return is_on_ && configuration_.sound.speaks; }

    // Back's contact, before the visit hears of it. What of it the visit should hear now.
    enum class Passes { AsItIs, Nothing, WholePress };
    Passes hear_back(bool is_down, base::Instant now);
    void let_go() { handset_.let_go(); }

    // Once a frame, where it is on. on_show: what the landscapes on the screen are grown from; `act` numbers them.
    void look(const Subject& subject, std::span<const genome::Recipe> on_show, int act);
    // Nobody is there to hear anything: the house is closed.
    void be_silent(base::Instant now);
    void follow();  // the configuration has changed

    bool is_speaking(base::Instant now) const { return speaks() && narrator_.speaks_until() > now; }
    // Once a frame: whether it is speaking, or was when this was asked last.
    bool has_spoken(base::Instant now);
    base::Instant speaks_until() const { return narrator_.speaks_until(); }
    std::optional<base::Instant> next_deadline(base::Instant now) const;
    Health health() const;

  private:
    void carry_out(const std::vector<Cue>& cues);
    void carry_out_wish(const Subject& subject);
    void surround(const Subject& subject, std::span<const genome::Recipe> on_show, int act);

    const site::Configuration& configuration_;
    bool is_on_;  // as the site said at the start
    Aloud aloud_;
    Narrator narrator_;
    Handset handset_;
    std::unique_ptr<Concert> concert_;  // or null
    bool was_speaking_ = false;
    exhibit::Screen screen_ = exhibit::Screen::Attract;
    struct Shown {
        int act = -1;
        std::size_t count = 0;
        std::optional<std::size_t> which;
        friend bool operator==(const Shown&, const Shown&) = default;
    } shown_;
};

}  // namespace quadrat::hearing
