// SPDX-License-Identifier: Apache-2.0
// Visits played by somebody who answers every two seconds, on a screen that nobody sees, against the clock.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "base/file.hpp"
#include "firmware-io/scripted/scripted_buttons.hpp"
#include "kiosk/benches/benches.hpp"
#include "kiosk/benches/scratch.hpp"
#include "kiosk/benches/visit_plot.hpp"
#include "kiosk/detail/memory.hpp"
#include "kiosk/heap.hpp"
#include "kiosk/run_loop.hpp"

namespace quadrat::kiosk::benches {
namespace {

using std::chrono::seconds;

constexpr Instant kPause = seconds{2};  // between presses
constexpr Instant kSlowUpload = std::chrono::milliseconds{3};

// Another screen, and what was seen on it.
class WatchedScreen final : public display::Display {
  public:
    WatchedScreen(display::Display& screen, Clock& clock, Show& show, DetailGovernor& governor, Instant until,
                  bool is_busy, std::atomic<bool>& stop)
        : Display("to be watched"),
          screen_(screen),
          clock_(clock),
          show_(show),
          governor_(governor),
          until_(until),
          is_busy_(is_busy),
          stop_(stop) {}

    std::string_view kind() const override { return screen_.kind(); }
    std::string description() const override { return screen_.description(); }
    display::Canvas canvas() const override { return screen_.canvas(); }
    display::Canvas begin_frame() override { return screen_.begin_frame(); }
    display::Presented present() override {
        display::Presented presented = screen_.present();
        Instant now = clock_.now();
        // Another process takes the bus from what is uploaded.
        if (is_busy_ && show_.is_growing() && now > until_ / 3 && now < 2 * until_ / 3) {
            while (clock_.now() - now < kSlowUpload) continue;
            now = clock_.now();
        }
        const int act = show_.on_stage().number;
        const bool is_first = frames_.empty();
        FrameSeen frame{now,
                        is_first ? Instant{0} : presented.shown_at - shown_at_,
                        presented.period * governor_.periods(),
                        governor_.level(),
                        show_.is_growing(),
                        act};
        const exhibit::Screen screen = show_.state().screen;
        // A visitor who is kept waiting presses on: what counts is the press that was the last answer, when it was
        // made, not when a frame came to hear of it.
        const bool was_breeding = screen_before_ == exhibit::Screen::Breed;
        if (!was_breeding) answered_at_ = show_.last_press_at() / kPause * kPause;
        const bool was_answered = was_breeding || screen_before_ == exhibit::Screen::Ask;
        if (!is_first && act != frames_.back().act && screen == exhibit::Screen::Ask && was_answered)
            frame.since_press = now - answered_at_;
        screen_before_ = screen;
        shown_at_ = presented.shown_at;
        frames_.push_back(frame);
        if (now >= until_) stop_ = true;
        return presented;
    }
    void set_power(display::Power power) override { screen_.set_power(power); }
    const std::vector<FrameSeen>& frames() const { return frames_; }

  private:
    display::Display& screen_;
    Clock& clock_;
    Show& show_;
    DetailGovernor& governor_;
    Instant until_;
    bool is_busy_;
    std::atomic<bool>& stop_;
    Instant shown_at_{0};
    Instant answered_at_{0};
    exhibit::Screen screen_before_ = exhibit::Screen::Attract;
    std::vector<FrameSeen> frames_;
};

std::unique_ptr<firmware_io::ButtonSource> visitor_for(Instant span) {
    base::RandomStream liking{base::Seed{5}.child("visitor")};
    firmware_io::scripted::ScriptWriter writer;
    for (Instant at = 2 * kPause; at < span; at += kPause)
        writer.at(at).press(static_cast<firmware_io::Button>(liking.below(4)));
    return std::make_unique<firmware_io::scripted::ScriptedButtons>(writer.script());
}

// Keeps a core busy for the middle third.
std::jthread competitor(Instant span) {
    return std::jthread([span](const std::stop_token& stop) {
        const auto began = std::chrono::steady_clock::now();
        while (!stop.stop_requested()) {
            const auto at = std::chrono::steady_clock::now() - began;
            if (at > 2 * span / 3) return;
            if (at < span / 3) std::this_thread::sleep_for(std::chrono::milliseconds{20});
        }
    });
}

double milliseconds(Instant span) { return std::chrono::duration<double, std::milli>(span).count(); }

}  // namespace

void visit(Results& results, const Options& options) {
    give_memory_back();  // as quadrat run does
    const Scratch scratch;
    Configuration configuration;
    display::DisplayOptions wanted;
    wanted.kind = display::Kind::Headless;
    wanted.size = display::size_from(options.size, "--size");
    const Instant span{static_cast<Instant::rep>(options.minutes * 60e9)};
    wanted.paces = {{options.hz}};
    if (options.then_hz > 0) wanted.paces.push_back({options.then_hz, 2 * span / 3});
    const auto screen = display::open_display(wanted);
    const auto buttons = visitor_for(span);
    Panel panel(*buttons);
    SteadyClock clock;
    const auto wall_time = [] {
        return std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now());
    };
    Show show(configuration, {base::Seed{1}, {}, wall_time, wall_time, scratch.path},
              exhibit::Archive::open(scratch.path, wall_time()).archive);
    DetailGovernor governor(options_for(options.alpha, "", screen->description()));
    std::atomic<bool> stop{false};
    WatchedScreen watched(*screen, clock, show, governor, span, options.is_busy, stop);
    RunLoopParts parts{configuration, clock, watched, panel, *buttons, show};
    parts.governor = &governor;
    parts.stop = &stop;
    {
        std::jthread busy;
        if (options.is_busy) busy = competitor(span);
        run_loop(parts);
    }
    // Until it has found what the machine can do, every frame may be late.
    constexpr Instant kSettled = seconds{20};
    std::vector<double> to_scenes;
    std::size_t frames = 0;
    std::size_t late = 0;
    double longest = 0;
    for (const FrameSeen& frame : watched.frames()) {
        if (frame.since_press.count() > 0) to_scenes.push_back(milliseconds(frame.since_press));
        if (frame.at < kSettled) continue;
        ++frames;
        const double periods = milliseconds(frame.took) / milliseconds(frame.deadline);
        late += periods > 1.25;
        longest = std::max(longest, periods);
    }
    const double share = frames == 0 ? 0 : 100.0 * static_cast<double>(late) / static_cast<double>(frames);
    results.push_back({"visit.late_frames_percent", share, "%", cores()});
    results.push_back({"visit.longest_frame", longest, "deadlines", cores()});
    results.push_back({"visit.press_to_scenes_p50_ms", percentile(to_scenes, 0.5), "ms", cores()});
    results.push_back({"visit.press_to_scenes_p95_ms", percentile(to_scenes, 0.95), "ms", cores()});
    results.push_back({"visit.generations", static_cast<double>(to_scenes.size()), "", cores()});
    results.push_back({"visit.level", governor.settled(), "", cores()});
    results.push_back({"visit.deadline_ms", milliseconds(watched.frames().back().deadline), "ms", cores()});
    if (!options.plot.empty()) base::write_file(options.plot, plot_of(watched.frames()));
}

}  // namespace quadrat::kiosk::benches
