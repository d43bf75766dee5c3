// SPDX-License-Identifier: Apache-2.0
#include "kiosk/run_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "base/log.hpp"
#include "firmware-io/keyboard/keyboard_buttons.hpp"
#include "kiosk/service.hpp"

namespace quadrat::kiosk {
namespace {

using exhibit::Screen;
using firmware_io::Button;
using firmware_io::LampPattern;
using firmware_io::Motion;

constexpr std::size_t kUploadSliceBytes = 1U << 20U;  // well under 2 ms of copying on the slowest box
constexpr std::size_t kAll = static_cast<std::size_t>(-1);
constexpr Instant kFrame = std::chrono::nanoseconds{16'666'667};

exhibit::Choice choice_of(Button button) { return static_cast<exhibit::Choice>(button); }

char key_of(display::Key key) {
    switch (key) {
        case display::Key::A:
        case display::Key::One:
            return 'A';
        case display::Key::B:
        case display::Key::Two:
            return 'B';
        case display::Key::C:
        case display::Key::Three:
            return 'C';
        case display::Key::D:
        case display::Key::Four:
            return 'D';
        case display::Key::Backspace:
        case display::Key::Left:
            return firmware_io::keyboard::kBackspace;
        default:
            return 0;
    }
}

// What lights up is what can be pressed now.
firmware_io::Lamps lamps_for(const Show& show) {
    const bool asks = show.state().screen == Screen::Ask;
    const bool invites = show.state().screen == Screen::Attract || show.state().screen == Screen::StillThere;
    firmware_io::Lamps lamps;
    lamps.fill(asks ? LampPattern::Steady : invites ? LampPattern::Breathing : LampPattern::Off);
    lamps[firmware_io::index_of(Button::Back)] = show.can_go_back() ? LampPattern::Steady : LampPattern::Off;
    if (show.state().screen == Screen::StillThere) lamps.fill(LampPattern::Blinking);
    return lamps;
}

class Loop {
  public:
    explicit Loop(const RunLoopParts& parts) : parts_(parts), theatre_(parts.configuration) {}

    RunEnd run() {
        parts_.show.open(parts_.clock.now());
        for (;;) {
            const Instant now = parts_.clock.now();
            const display::Canvas canvas = parts_.display.begin_frame();
            theatre_.enter(canvas);
            hear(now);
            show_what_has_grown(now);
            if (canvas.context != 0) keep_pictures(canvas);
            theatre_.draw(parts_.show, parts_.show.growing_progress(), now, canvas);
            const display::Presented presented = parts_.display.present();
            report(presented);
            if (const auto end = ending(presented)) return *end;
            pass_time(now, presented);
        }
    }

  private:
    void hear(Instant now) {
        for (const display::KeyMotion& key : parts_.display.take_keys()) {
            if (key.key == display::Key::Escape || key.key == display::Key::Q) wants_to_quit_ = true;
            const Motion motion = key.move == display::KeyMove::Down ? Motion::Down : Motion::Up;
            if (key_of(key.key) != 0) parts_.buttons.key(key_of(key.key), motion, now);
        }
        for (const firmware_io::ButtonEdge& edge : parts_.buttons.poll(now)) {
            if (edge.motion == Motion::Down)
                parts_.show.happen(exhibit::Pressed{choice_of(edge.button)}, now);
            else
                parts_.show.happen(exhibit::Released{choice_of(edge.button)}, now);
        }
        parts_.show.happen(exhibit::Tick{}, now);
        parts_.buttons.set_lamps(lamps_for(parts_.show));
        if (const auto status = parts_.buttons.status(); status != last_status_) {
            last_status_ = status;
            if (status.presence == firmware_io::Presence::Absent)
                base::log::warn("buttons: {}", status.reason);
            else if (!status.reason.empty())
                base::log::info("buttons: {}", status.reason);
        }
    }

    void show_what_has_grown(Instant now) {
        if (parts_.clock.is_simulated()) parts_.show.finish_growing();
        const std::size_t budget = parts_.clock.is_simulated() ? kAll : kUploadSliceBytes;
        // What is on stage comes first: after a change of context it is missing too.
        if (theatre_.prepare(parts_.show.on_stage(), budget)) {
            if (const Act* act = parts_.show.waiting_for_upload(); act != nullptr && theatre_.prepare(*act, budget)) {
                parts_.show.uploaded(now);
                theatre_.keep_only(parts_.show.in_use());
                if (parts_.clock.is_simulated()) theatre_.prepare(parts_.show.on_stage(), kAll);
            }
        }
        if (!is_announced_ && !parts_.show.on_stage().scenes.empty()) {
            is_announced_ = true;
            announce_ready();
        }
    }

    void keep_pictures(const display::Canvas& canvas) {
        const Screen screen = parts_.show.state().screen;
        const Act& act = parts_.show.on_stage();
        const bool is_worth_it = screen == Screen::Ask || screen == Screen::Finale;
        if (parts_.album == nullptr || !is_worth_it || act.number == photographed_ || act.recipes.empty()) return;
        photographed_ = act.number;
        const Picture picture = picture_of(act, canvas, parts_.configuration);
        const bool is_finale = screen == Screen::Finale;
        const std::string name =
            is_finale ? fmt::format("finale-{:02}", ++finales_) : fmt::format("generation-{:02}", ++generations_);
        const std::string caption = is_finale ? "The finale" : fmt::format("Round {}", parts_.show.state().rounds + 1);
        parts_.album->add(name, theatre_.photograph(act, picture, canvas), picture, caption);
        base::log::info("picture {} of round {}", name + ".png", parts_.show.state().rounds + (is_finale ? 0 : 1));
    }

    void report(const display::Presented& presented) {
        using display::Outcome;
        if (presented.outcome != last_outcome_) {
            last_outcome_ = presented.outcome;
            if (presented.outcome == Outcome::Shown)
                base::log::info("screen: shows again");
            else
                base::log::warn("screen: {}", presented.reason);
        }
        if (presented.outcome != Outcome::Fault) feed_watchdog();
    }

    std::optional<RunEnd> ending(const display::Presented& presented) const {
        if (parts_.stop != nullptr && parts_.stop->load()) return RunEnd::Stopped;
        if (wants_to_quit_ || parts_.display.wants_to_close()) return RunEnd::WindowClosed;
        if (presented.outcome == display::Outcome::Fault) return RunEnd::DisplayFault;
        if (parts_.ends_after_visit && parts_.show.visits_ended() > 0) return RunEnd::VisitOver;
        const bool is_script_over = parts_.clock.is_simulated() && parts_.buttons.is_finished() &&
                                    parts_.show.state().screen == Screen::Attract && !next_moment().has_value();
        if (is_script_over) return RunEnd::ScriptOver;
        return std::nullopt;
    }

    // When something will happen by itself.
    std::optional<Instant> next_moment() const {
        const auto press = parts_.buttons.next_event_at();
        const auto deadline = exhibit::next_deadline(parts_.show.state(), parts_.show.timings());
        if (press && deadline) return std::min(*press, *deadline);
        return press ? press : deadline;
    }

    void pass_time(Instant now, const display::Presented& presented) {
        if (parts_.clock.is_simulated()) {
            // A wish that was granted can change what comes next at once: never skip while something waits.
            parts_.clock.skip_to(std::max(now + std::chrono::milliseconds{1}, next_moment().value_or(now)));
            return;
        }
        if (presented.period.count() == 0 || presented.outcome != display::Outcome::Shown)
            std::this_thread::sleep_until(std::chrono::steady_clock::now() +
                                          std::max(Instant{0}, now + kFrame - parts_.clock.now()));
    }

    const RunLoopParts& parts_;
    Theatre theatre_;
    firmware_io::SourceStatus last_status_;
    display::Outcome last_outcome_ = display::Outcome::Shown;
    bool wants_to_quit_ = false;
    bool is_announced_ = false;
    int photographed_ = 0;
    int generations_ = 0;
    int finales_ = 0;
};

}  // namespace

RunEnd run_loop(const RunLoopParts& parts) { return Loop(parts).run(); }

}  // namespace quadrat::kiosk
