// SPDX-License-Identifier: Apache-2.0
// Visits played by somebody who answers about every two seconds, on a screen that nobody sees, against the clock.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <thread>

#include "base/worker.hpp"
#include "benches/benches.hpp"
#include "benches/scratch.hpp"
#include "benches/visit_plot.hpp"
#include "firmware-io/scripted/scripted_buttons.hpp"
#include "kiosk/run_loop.hpp"
#include "machine/heap.hpp"
#include "staff/caretaker.hpp"
#include "staff/presence.hpp"
#include "tempo/memory.hpp"

namespace quadrat::benches {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;

// Between presses. Not a multiple of a screen's period at 24, 30, 50 or 60 Hz: each press would come in the same phase
// of a frame, and the times from it to the scenes would be those of that phase only.
constexpr base::Instant kPause = std::chrono::milliseconds{2007};
constexpr base::Instant kSlowUpload = std::chrono::milliseconds{3};
constexpr base::Instant kWeighEvery = std::chrono::milliseconds{500};

// Another screen, and what was seen on it.
class WatchedScreen final : public display::Display {
  public:
    WatchedScreen(display::Display& screen, base::Clock& clock, kiosk::Show& show, const tempo::Tempo& tempo,
                  base::Instant until, bool is_busy, std::atomic<bool>& stop)
        : Display("to be watched"),
          screen_(screen),
          clock_(clock),
          show_(show),
          tempo_(tempo),
          until_(until),
          is_busy_(is_busy),
          stop_(stop) {}

    std::string_view kind() const override { return screen_.kind(); }
    std::string description() const override { return screen_.description(); }
    std::string renderer() const override { return screen_.renderer(); }
    display::Canvas canvas() const override { return screen_.canvas(); }
    display::Canvas begin_frame() override { return screen_.begin_frame(); }
    display::Presented present(const tempo::HandOver& how) override {
        display::Presented presented = screen_.present(how);
        base::Instant now = clock_.now();
        // Another process takes the bus from what is uploaded.
        if (is_busy_ && show_.programme().is_growing() && now > until_ / 3 && now < 2 * until_ / 3) {
            while (clock_.now() - now < kSlowUpload) continue;
            now = clock_.now();
        }
        const int act = show_.on_stage().number;
        const bool is_first = frames_.empty();
        FrameSeen frame{now,
                        base::Instant{0},
                        presented.period * how.meant_periods,
                        presented.period,
                        tempo_.plan().level,
                        show_.programme().is_growing(),
                        act};
        const exhibit::Screen screen = show_.state().screen;
        // A visitor who is kept waiting presses on: what counts is the press that was the last answer, when it was
        // made, not when a frame came to hear of it.
        const bool was_breeding = screen_before_ == exhibit::Screen::Breed;
        if (!was_breeding)
            answered_at_ = (show_.last_press() ? show_.last_press()->at : base::Instant{0}) / kPause * kPause;
        const bool was_answered = was_breeding || screen_before_ == exhibit::Screen::Ask;
        if (!is_first && act != frames_.back().act && screen == exhibit::Screen::Ask && was_answered)
            answers_[frames_.size()] = answered_at_;
        screen_before_ = screen;
        if (frames_.empty() || now / kWeighEvery != frames_.back().at / kWeighEvery)
            resident_mb_.push_back(machine::resident_memory_mb());
        frames_.push_back(frame);
        tell_shown(presented);
        // As the caretaker of quadrat run does.
        if (times_to_tidy_.is_due(show_.visits_ended(), now)) tidying_.send(machine::tidy_memory);
        if (now >= until_) stop_ = true;
        return presented;
    }
    void set_power(display::Power power) override { screen_.set_power(power); }
    const std::vector<FrameSeen>& frames() const { return frames_; }
    const std::vector<double>& resident_mb() const { return resident_mb_; }

  private:
    void tell_shown(const display::Presented& presented) {
        for (const tempo::FrameRecord& record : presented.finished) {
            const std::size_t at = record.number - 1;
            FrameSeen& frame = frames_[at];
            frame.took = tempo::took(record);
            frame.is_late = tempo::is_late(record);
            if (const auto answered = answers_.find(at); answered != answers_.end())
                frame.since_press = record.shown - began_at_ - answered->second;
        }
    }

    display::Display& screen_;
    base::Clock& clock_;
    kiosk::Show& show_;
    const tempo::Tempo& tempo_;
    base::Instant until_;
    bool is_busy_;
    std::atomic<bool>& stop_;
    base::DisplayTime began_at_ = screen_.now() - clock_.now();  // the show
    base::Instant answered_at_{0};
    std::map<std::size_t, base::Instant>
        answers_;  // that the frame of this place is the first to show the next four for
    exhibit::Screen screen_before_ = exhibit::Screen::Attract;
    std::vector<FrameSeen> frames_;
    std::vector<double> resident_mb_;  // now and then
    machine::TimesToTidy times_to_tidy_;
    base::Worker tidying_{{.name = "tidying"}};
};

std::unique_ptr<firmware_io::ButtonSource> visitor_for(base::Instant span) {
    base::RandomStream liking{base::Seed{5}.child("visitor")};
    firmware_io::scripted::ScriptWriter writer;
    for (base::Instant at = 2 * kPause; at < span; at += kPause)
        writer.at(at).press(static_cast<firmware_io::Button>(liking.below(4)));
    return std::make_unique<firmware_io::scripted::ScriptedButtons>(writer.script());
}

// Keeps a core busy for the middle third.
std::jthread competitor(base::Instant span) {
    return std::jthread([span](const std::stop_token& stop) {
        const auto began = std::chrono::steady_clock::now();
        while (!stop.stop_requested()) {
            const auto at = std::chrono::steady_clock::now() - began;
            if (at > 2 * span / 3) return;
            if (at < span / 3) std::this_thread::sleep_for(std::chrono::milliseconds{20});
        }
    });
}

double milliseconds(base::Instant span) { return std::chrono::duration<double, std::milli>(span).count(); }

// What is said of the frames from then on.
void add_frames(Results& results, const std::vector<FrameSeen>& all, base::Instant from) {
    std::size_t late = 0;
    std::size_t late_of_screen = 0;
    std::size_t in_two_periods = 0;
    double longest = 0;
    base::Instant longest_took{0};
    const auto first = std::ranges::lower_bound(all, from, {}, &FrameSeen::at);
    for (auto frame = first; frame != all.end(); ++frame) {
        const double took_ms = milliseconds(frame->took);
        late += frame->is_late;
        late_of_screen += took_ms > 1.5 * milliseconds(frame->period);
        in_two_periods += frame->deadline > frame->period;
        longest = std::max(longest, took_ms / milliseconds(frame->deadline));
        longest_took = std::max(longest_took, frame->took);
    }
    const auto frames = std::max<std::ptrdiff_t>(all.end() - first, 1);
    const auto percent = [&](std::size_t count) {
        return 100.0 * static_cast<double>(count) / static_cast<double>(frames);
    };
    results.push_back({"visit.late_frames_percent", percent(late), "%", cores()});
    results.push_back({"visit.two_periods_percent", percent(in_two_periods), "% meant to take two", cores()});
    results.push_back({"visit.late_of_screen_percent", percent(late_of_screen), "% of one period", cores()});
    results.push_back({"visit.longest_frame", longest, "deadlines", cores()});
    results.push_back({"visit.longest_frame_ms", milliseconds(longest_took), "ms", cores()});
}

void add_uploads(Results& results, const std::vector<FrameSeen>& frames, const kiosk::RunRecord& record,
                 base::Instant from) {
    // The frame that ended the visit is in both, in the same place.
    std::vector<double> took_ms;
    for (std::size_t i = 0; i < std::min(frames.size(), record.uploads_took.size()); ++i)
        if (frames[i].at >= from) took_ms.push_back(milliseconds(record.uploads_took[i]));
    results.push_back({"visit.upload_p99_ms", machine::percentile(took_ms, 0.99), "ms", cores()});
    results.push_back({"visit.upload_longest_ms", machine::percentile(took_ms, 1), "ms", cores()});
}

// Whoever looks after the exhibit, as quadrat run has them.
struct Attendance {
    Attendance(const fs::path& folder, site::Configuration& configuration, const display::Display& screen)
        : presence(folder),
          ladder("", folder, staff::Seconds{0}),
          caretaker({configuration, as_read(configuration), folder, folder, ladder, screen}) {}

    static site::Settings as_read(const site::Configuration& configuration) {
        site::Settings settings;
        settings.configuration = configuration;
        return settings;
    }

    staff::Presence presence;
    staff::Ladder ladder;
    staff::Caretaker caretaker;
};

}  // namespace

void visit(Results& results, const Options& options) {
    machine::hold_memory();  // as quadrat run does
    const Scratch scratch;
    site::Configuration configuration;
    display::DisplayOptions wanted;
    wanted.kind = display::Kind::Headless;
    wanted.size = display::size_from(options.size, "--size");
    const base::Instant span{static_cast<base::Instant::rep>(options.minutes * 60e9)};
    wanted.paces = {{options.hz}};
    if (options.then_hz > 0) wanted.paces.push_back({options.then_hz, 2 * span / 3});
    const auto screen = display::open_display(wanted);
    results.gpu = screen->description();
    const auto buttons = visitor_for(span);
    staff::Panel panel(*buttons);
    base::SteadyClock clock;
    const auto wall_time = [] {
        return std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now());
    };
    kiosk::Show show(configuration, {base::Seed{1}, {}, wall_time, wall_time, scratch.path},
                     archive::Archive::open(scratch.path, wall_time()).archive);
    tempo::Tempo tempo({tempo::Governing::ByFrames, tempo::options_for(options.alpha, "", screen->renderer())});
    std::atomic<bool> stop{false};
    WatchedScreen watched(*screen, clock, show, tempo, span, options.is_busy, stop);
    kiosk::RunLoopParts parts{configuration, clock, watched, panel, *buttons, show, tempo};
    parts.stop = &stop;
    std::optional<Attendance> attendance;
    if (!options.attended.empty()) attendance.emplace(options.attended, configuration, *screen);
    if (attendance) parts.attendant = &attendance->caretaker;
    kiosk::RunRecord record;
    parts.watcher = &record;
    {
        std::jthread busy;
        if (options.is_busy) busy = competitor(span);
        kiosk::run_loop(parts);
    }
    // Until it has found what the machine can do, every frame may be late.
    const base::Instant settled = std::min<base::Instant>(seconds{20}, span / 2);
    std::vector<double> to_scenes;
    for (const FrameSeen& frame : watched.frames())
        if (frame.since_press.count() > 0) to_scenes.push_back(milliseconds(frame.since_press));
    add_frames(results, watched.frames(), settled);
    add_uploads(results, watched.frames(), record, settled);
    results.push_back(
        {"visit.resident_mb", machine::percentile(watched.resident_mb(), 0.5), "MB, the median", cores()});
    results.push_back({"visit.resident_peak_mb", machine::percentile(watched.resident_mb(), 1), "MB", cores()});
    results.push_back({"visit.press_to_scenes_p50_ms", machine::percentile(to_scenes, 0.5), "ms", cores()});
    results.push_back({"visit.press_to_scenes_p95_ms", machine::percentile(to_scenes, 0.95), "ms", cores()});
    results.push_back({"visit.generations", static_cast<double>(to_scenes.size()), "", cores()});
    results.push_back({"visit.level", tempo.governor().settled(), "", cores()});
    results.push_back({"visit.deadline_ms", milliseconds(watched.frames().back().deadline), "ms", cores()});
    results.visit_svg = plot_of(watched.frames(), record.decisions);
}

}  // namespace quadrat::benches
