// SPDX-License-Identifier: Apache-2.0
#include "kiosk/run_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "base/log.hpp"
#include "display/shown_frames.hpp"
#include "kiosk/signals.hpp"
#include "kiosk/start_report.hpp"
#include "machine/heap.hpp"
#include "machine/service.hpp"
#include "stage/trial.hpp"
#include "tempo/cadence.hpp"
#include "tempo/memory.hpp"
#include "tempo/upload_time.hpp"

namespace quadrat::kiosk {
namespace {

using exhibit::Screen;
using firmware_io::Motion;

// Of each frame, for what is brought to the GPU: by the clock (UploadTime) for what this processor copies, by bytes for
// what the GPU does with it.
constexpr std::size_t kUploadBytes = 4U << 20U;
constexpr base::Instant kFrame = std::chrono::nanoseconds{16'666'667};
constexpr base::Instant kLongestFrame = std::chrono::seconds{1};
constexpr std::chrono::seconds kUntilCalm{5};     // landscapes have grown in, and were looked at
constexpr std::chrono::seconds kTimeToGrow{120};  // the next part of the first four; as TimeoutStartSec=

class Loop {
  public:
    explicit Loop(const RunLoopParts& parts) : parts_(parts), theatre_(parts.configuration) {
        if (parts.budget) budget_.emplace(*parts.budget, static_cast<float>(parts.configuration.picture.alpha));
    }

    RunEnd run() {
        parts_.show.open(parts_.clock.now());
        for (;;) {
            const base::Instant now = parts_.clock.now();
            const display::Canvas canvas = parts_.display.begin_frame();
            theatre_.enter(canvas);
            // One frame ahead of the GPU is enough: more would be late, and take memory.
            if (!parts_.clock.is_simulated() && theatre_.is_drawn_within(kLongestFrame) && frames_ > 0)
                start_.drawn(had_landscapes_);
            hear(now);
            const base::Instant begun = parts_.clock.now();
            show_what_has_grown(now);
            if (parts_.record != nullptr) parts_.record->uploads_took.push_back(parts_.clock.now() - begun);
            brace();
            const base::Instant drawing_since = parts_.clock.now();
            if (!is_dark()) draw(canvas, now);
            had_landscapes_ = !parts_.show.on_stage().scenes.empty();
            ++frames_;
            const float used = time_used(now);
            upload_time_.drew(parts_.clock.now() - drawing_since);
            wait_for_its_period();
            handed_over_at_ = std::chrono::steady_clock::now().time_since_epoch();
            const display::Presented presented = parts_.display.present();
            report(presented, now);
            govern(presented, now, used);
            if (const auto end = ending(presented)) return *end;
            pass_time(now, presented);
        }
    }

  private:
    bool is_dark() const {
        return parts_.caretaker != nullptr && parts_.caretaker->curtain() == site::Curtain::Dark &&
               parts_.caretaker->board() == nullptr;
    }

    void hear(base::Instant now) {
        for (const display::KeyMotion& key : parts_.display.take_keys()) {
            if (key.key == display::Key::Escape || key.key == display::Key::Q) wants_to_quit_ = true;
            if (key.key == display::Key::F1 && key.move == display::KeyMove::Down && parts_.caretaker != nullptr)
                parts_.caretaker->step_figures();
            const Motion motion = key.move == display::KeyMove::Down ? Motion::Down : Motion::Up;
            if (key_of(key.key) != 0) parts_.buttons.key(key_of(key.key), motion, now);
        }
        const auto edges = parts_.panel.poll(now);
        look_after(now);
        for (const firmware_io::ButtonEdge& edge : edges) {
            if (parts_.caretaker != nullptr && parts_.caretaker->hear(edge, now)) continue;
            if (edge.motion == Motion::Down)
                parts_.show.happen(exhibit::Pressed{choice_of(edge.button)}, now);
            else
                parts_.show.happen(exhibit::Released{choice_of(edge.button)}, now);
        }
        parts_.show.happen(exhibit::Tick{}, now);
        const auto lamps = parts_.caretaker != nullptr ? parts_.caretaker->lamps(now) : std::nullopt;
        parts_.panel.light(lamps.value_or(lamps_for(parts_.show)), now);
        if (parts_.caretaker == nullptr) return;
        const display::Power power = is_dark() ? display::Power::Off : display::Power::On;
        if (power != power_) parts_.display.set_power(power_ = power);
    }

    void look_after(base::Instant now) {
        if (parts_.caretaker == nullptr) return;
        Show& show = parts_.show;
        const staff::Orders orders = parts_.caretaker->look(
            parts_.panel, {show.state().screen != Screen::Attract, show.visits_ended(), show.state_trouble()}, now);
        if (orders.follows_settings) show.follow(parts_.configuration);
        if (orders.buttons_memory) show.remember("buttons", *orders.buttons_memory);
    }

    void draw(const display::Canvas& canvas, base::Instant now) {
        if (canvas.context != 0) keep_pictures(canvas, now);
        if (!parts_.clock.is_simulated()) theatre_.rehearse(canvas);  // or no frame can come late
        calibrate(canvas, now);
        stage::Theatre::Over over;
        if (parts_.caretaker != nullptr) over.board = parts_.caretaker->board();
        if (parts_.caretaker != nullptr) over.sign = parts_.caretaker->sign();
        if (parts_.keepsakes != nullptr && shows_earlier_landscapes()) over.backdrop = parts_.keepsakes->at(now);
        if (budget_) theatre_.set_detail(budget_->detail({canvas.size.width, canvas.size.height}));
        drawn_ = theatre_.draw(moment_of(parts_.show, now), canvas, over);
        if (budget_) budget_->drew(drawn_.triangles);
        if (parts_.caretaker == nullptr) return;
        if (const std::string file = parts_.caretaker->take_picture_wish(); !file.empty())
            parts_.caretaker->keep_picture(theatre_.read_back(), file);
    }

    // On a GPU that is not known yet, while nobody is there and nothing grows: some frames come late for it, once.
    void calibrate(const display::Canvas& canvas, base::Instant now) {
        const nursery::Act& act = parts_.show.on_stage();
        const bool is_calm = parts_.show.state().screen == exhibit::Screen::Attract && !parts_.show.is_growing() &&
                             act.scenes.size() == genome::kCandidates && now - act.arrived > kUntilCalm;
        if (!is_calibrating() || !is_calm || !canvas.is_seen) return;
        if (!trial_) trial_.emplace(theatre_.most_samples());
        frames_not_judged_ = 3;
        const std::optional<tempo::GpuProfile> profile = theatre_.try_out(*trial_, act, canvas);
        if (!profile) return;
        const double period_ms = std::chrono::duration<double, std::milli>(period_).count();
        const auto most = static_cast<float>(parts_.configuration.picture.alpha);
        *parts_.governor = tempo::DetailGovernor(tempo::start_for(*profile, most, period_ms));
        base::log::info("GPU: {}; detail {:.2f}{}", to_text(*profile), parts_.governor->settled(),
                        parts_.governor->samples() > 1 ? ", smooth edges" : "");
        parts_.show.remember("gpu", to_text(*profile, parts_.display.renderer()));
        parts_.show.remember("detail", to_text(*parts_.governor, parts_.display.renderer()));
    }

    bool is_calibrating() const {
        const bool is_over = trial_ && trial_->is_over();
        return parts_.calibrates && !is_over && parts_.governor != nullptr && !budget_ && theatre_.has_gpu();
    }

    // The governor's; where nobody governs, alpha.
    float level() const {
        const bool is_governed = !budget_ && parts_.governor != nullptr;
        return is_governed ? parts_.governor->level() : alpha();
    }

    float alpha() const {
        const auto configured = static_cast<float>(parts_.configuration.picture.alpha);
        if (budget_) return theatre_.detail().alpha;
        return parts_.governor != nullptr ? tempo::alpha_for(parts_.governor->level()) : configured;
    }

    float scale() const {
        if (budget_) return theatre_.detail().scale;
        return parts_.governor != nullptr ? tempo::scale_for(parts_.governor->level()) : 1;
    }

    // Of the screen's, that a frame is meant to take.
    int periods() const { return parts_.governor != nullptr ? parts_.governor->periods() : 1; }

    base::Instant period_of(const display::Presented& presented) const {
        return presented.period.count() > 0 ? presented.period : kFrame;
    }

    // Of the frame's time, until it was drawn; waits no longer than there is time to hand it over.
    float time_used(base::Instant began) {
        if (parts_.governor == nullptr) return 1;
        const base::Instant all = period_ * periods();
        if (!theatre_.is_drawn_within(all * 9 / 10 - (parts_.clock.now() - began))) return 1;
        const float used = std::chrono::duration<float>(parts_.clock.now() - began) / all;
        return used > tempo::DetailGovernor::kRoom ? 1 : used;
    }

    // The next four, by who has answered.
    bool is_waited_for() const { return parts_.show.state().screen == exhibit::Screen::Breed; }

    void brace() {
        const bool is_growing = parts_.show.is_growing();
        const bool begins_to_grow = !std::exchange(was_growing_, is_growing) && is_growing;
        const int act = parts_.show.on_stage().number;
        const bool is_first = std::exchange(act_before_, act) != act;
        if (parts_.governor == nullptr || (!begins_to_grow && !is_first)) return;
        if (is_first) parts_.governor->other_landscapes(parts_.clock.now());
        parts_.governor->brace();
        set_detail();
    }

    void set_detail() {
        const float level = parts_.governor->level();
        theatre_.set_detail({tempo::alpha_for(level), tempo::scale_for(level), parts_.governor->samples()});
    }

    void govern(const display::Presented& presented, base::Instant now, float used) {
        if (parts_.governor == nullptr) return;
        period_ = period_of(presented);
        shown_at_ = presented.period.count() > 0 ? presented.shown_at : base::Instant{0};
        is_one_in_flight_ = presented.shown_frame < frames_;
        std::vector<base::Instant> shown = shown_frames_.since_last(presented);
        if (presented.period.count() == 0) shown = {now};
        tempo::DetailGovernor& governor = *parts_.governor;
        governor.follow(static_cast<float>(parts_.configuration.picture.alpha));
        if (theatre_.has_gpu()) governor.allow_samples(theatre_.most_samples());
        for (const base::Instant at : shown) {
            const base::Instant took = at - std::exchange(framed_at_, at);
            const bool is_shown = presented.outcome == display::Outcome::Shown && !is_dark();
            if (!is_shown || took > kLongestFrame) return;  // the screen was away
            if (frames_not_judged_ > 0 && frames_not_judged_-- > 0) continue;
            governor.frame({now, took, period_, used, parts_.show.is_growing() || is_waited_for()});
        }
        // Two frames nobody takes for a wait.
        if (!is_waited_for())
            frames_waited_ = 0;
        else if (++frames_waited_ == 3)
            governor.kept_waiting();
        set_detail();
        if (const auto why = governor.take_reason()) {
            base::log::info("{}", *why);
            if (parts_.record != nullptr) parts_.record->decisions.push_back({now, *why});
            // The plug may be pulled at any moment; once a minute is often enough for the disk.
            if (remembered_at_ && now - *remembered_at_ < std::chrono::minutes{1}) return;
            remembered_at_ = now;
            parts_.show.remember("detail", to_text(governor, parts_.display.renderer()));
        }
    }

    // Before the first four have grown, and in safe mode as long as nobody is there.
    bool shows_earlier_landscapes() const {
        if (parts_.show.on_stage().scenes.empty()) return true;
        return parts_.mode == staff::Mode::Safe && parts_.show.state().screen == exhibit::Screen::Attract;
    }

    void show_what_has_grown(base::Instant now) {
        if (parts_.clock.is_simulated()) parts_.show.finish_growing();
        // While nothing is on stage, no frame can come late.
        const bool is_dark_yet = parts_.show.on_stage().scenes.empty();
        const bool is_all = parts_.clock.is_simulated() || is_dark_yet;
        const bool is_waited_for = is_all || parts_.show.waiting_for_upload() != nullptr;
        theatre_.set_awaited(is_waited_for);
        const std::optional<base::Instant> time = upload_time_.next(period_ * periods(), is_waited_for);
        if (!time) return;
        const base::Instant until = parts_.clock.now() + *time;
        const stage::Theatre::Haste haste =
            is_all ? stage::Theatre::Haste::everything()
                   : stage::Theatre::Haste{kUploadBytes, [this, until] { return parts_.clock.now() < until; }, 1};
        // What is on stage comes first: after a change of context it is missing too.
        if (!theatre_.prepare(parts_.show.on_stage(), haste)) return;
        const nursery::Act* act = parts_.show.waiting_for_upload();
        if (act != nullptr) {
            // A visitor waits for these, and their first light is painted quickly.
            stage::Theatre::Haste quick = haste;
            quick.scenes = static_cast<int>(act->scenes.size());
            if (!theatre_.prepare(*act, quick)) return;
            // A flush takes a millisecond or two where nothing is wrong, and a frame more would be seen.
            if (!parts_.show.is_kept_within(std::max(until - parts_.clock.now(), base::Instant{0}))) return;
            parts_.show.uploaded(now);
            theatre_.keep_only(parts_.show.in_use());
            if (is_all) theatre_.prepare(parts_.show.on_stage(), haste);
            if (!std::exchange(has_given_back_, true)) machine::give_memory_back();
        } else if (const nursery::Act* refined = parts_.show.waiting_to_refine(); refined != nullptr) {
            if (!theatre_.prepare(*refined, haste)) return;
            parts_.show.refined();
            theatre_.keep_only(parts_.show.in_use());
        } else {
            theatre_.prepare_ahead(parts_.show.ahead(), haste);
        }
    }

    void keep_pictures(const display::Canvas& canvas, base::Instant now) {
        keep_earlier_landscape(canvas, now);
        const exhibit::Screen screen = parts_.show.state().screen;
        const nursery::Act& act = parts_.show.on_stage();
        const bool is_seen =
            screen == exhibit::Screen::Ask || screen == exhibit::Screen::Slide || screen == exhibit::Screen::Finale;
        if (is_seen) round_ = parts_.show.state().rounds + 1;
        // Whoever answers before its light is refined still finds it in the album.
        const bool is_worth_it = (is_seen && parts_.show.is_refined()) || screen == exhibit::Screen::Breed;
        // Acts come one after another; what is still on stage when a visit begins is of the visit before.
        if (parts_.album == nullptr || !is_worth_it || act.number <= photographed_ || act.recipes.empty()) return;
        photographed_ = act.number;
        const pictures::Picture picture = stage::picture_of(act, canvas, parts_.configuration);
        const bool is_finale = screen == exhibit::Screen::Finale;
        const std::string name =
            is_finale ? fmt::format("finale-{:02}", ++finales_) : fmt::format("generation-{:02}", ++generations_);
        const std::string caption = is_finale ? "The finale" : fmt::format("Round {}", round_);
        parts_.album->add(name, theatre_.photograph(act, picture, canvas), picture, caption);
        base::log::info("picture {} of round {}", name + ".png", is_finale ? round_ - 1 : round_);
    }

    // Of a finale, while it is seen: one frame of it is drawn once more for the picture.
    void keep_earlier_landscape(const display::Canvas& canvas, base::Instant now) {
        const nursery::Act& act = parts_.show.on_stage();
        const bool is_finale = parts_.show.state().screen == exhibit::Screen::Finale && !act.recipes.empty();
        if (parts_.keepsakes == nullptr || parts_.caretaker == nullptr || parts_.mode == staff::Mode::Safe) return;
        if (!is_finale || !parts_.show.is_refined() || !parts_.keepsakes->wants_another(now)) return;
        const mesh::Image picture =
            theatre_.photograph(act, stage::picture_of(act, canvas, parts_.configuration), canvas);
        parts_.caretaker->keep_picture(staff::halved(picture), parts_.keepsakes->keep(now));
    }

    void report(const display::Presented& presented, base::Instant now) {
        using display::Outcome;
        if (parts_.caretaker != nullptr)
            parts_.caretaker->framed(
                presented, now,
                {level(), alpha(), scale(), drawn_.samples, periods(), drawn_.triangles, drawn_.draws, drawn_.objects});
        if (presented.outcome != last_outcome_) {
            last_outcome_ = presented.outcome;
            if (presented.outcome == Outcome::Shown)
                base::log::info("screen: shows again");
            else if (presented.outcome == Outcome::Off)
                base::log::info("screen: {}", presented.reason);
            else
                base::log::warn("screen: {}", presented.reason);
        }
        if (presented.outcome != Outcome::Fault) tell_service();
    }

    // Ready is who has drawn landscapes once: the first such frame compiles what it is drawn with, which takes longer
    // than the watchdog waits for a frame where the machine is slow. Until then there is time as long as they grow, and
    // the watchdog is left alone: fed once, it bites before READY too.
    void tell_service() {
        if (is_announced_) return machine::feed_watchdog();
        is_announced_ = !parts_.show.on_stage().scenes.empty();
        if (is_announced_) return machine::announce_ready();
        const float progress = parts_.show.growing_progress();
        if (std::exchange(progress_, progress) != progress) machine::ask_for_time(kTimeToGrow);
    }

    std::optional<RunEnd> ending(const display::Presented& presented) const {
        if (parts_.stop != nullptr && parts_.stop->load()) return RunEnd::Stopped;
        if (wants_to_quit_ || parts_.display.wants_to_close()) return RunEnd::WindowClosed;
        if (presented.outcome == display::Outcome::Fault) return RunEnd::DisplayFault;
        if (parts_.caretaker != nullptr && parts_.caretaker->wants_restart()) return RunEnd::Restart;
        if (parts_.ends_after_visit && parts_.show.visits_ended() > 0) return RunEnd::VisitOver;
        const bool is_script_over = parts_.clock.is_simulated() && parts_.buttons.is_finished() &&
                                    parts_.show.state().screen == exhibit::Screen::Attract &&
                                    !next_moment().has_value();
        if (is_script_over) return RunEnd::ScriptOver;
        return std::nullopt;
    }

    // When something will happen by itself.
    std::optional<base::Instant> next_moment() const {
        const auto press = parts_.buttons.next_event_at();
        const auto deadline = exhibit::next_deadline(parts_.show.state(), parts_.show.timings());
        if (press && deadline) return std::min(*press, *deadline);
        return press ? press : deadline;
    }

    void pass_time(base::Instant now, const display::Presented& presented) {
        if (parts_.clock.is_simulated()) {
            // A wish that was granted can change what comes next at once: never skip while something waits.
            parts_.clock.skip_to(std::max(now + std::chrono::milliseconds{1}, next_moment().value_or(now)));
            return;
        }
        if (presented.period.count() == 0 || presented.outcome != display::Outcome::Shown)
            std::this_thread::sleep_until(std::chrono::steady_clock::now() +
                                          std::max(base::Instant{0}, now + kFrame * periods() - parts_.clock.now()));
    }

    // A frame that is meant to take two of the screen's periods, and is ready in the first, is handed over in the
    // second.
    void wait_for_its_period() {
        if (periods() == 1 || shown_at_.count() == 0) return;
        tempo::Cadence cadence{period_, periods(), shown_at_};
        if (is_one_in_flight_) cadence.handed_over_at = handed_over_at_;
        std::this_thread::sleep_until(std::chrono::steady_clock::time_point{tempo::hand_over_at(cadence)});
    }

    const RunLoopParts& parts_;
    stage::Theatre theatre_;
    display::Power power_ = display::Power::On;
    display::Outcome last_outcome_ = display::Outcome::Shown;
    std::optional<stage::BudgetKeeper> budget_;
    std::optional<stage::Trial> trial_;
    int frames_not_judged_ = 0;  // what was tried out took their time
    render::Drawn drawn_;        // last
    StartReport start_;
    std::uint64_t frames_ = 0;
    bool had_landscapes_ = false;  // the last frame
    bool has_given_back_ = false;  // what the first landscapes took, once they were there
    bool wants_to_quit_ = false;
    bool is_announced_ = false;
    float progress_ = -1;
    base::Instant period_ = kFrame;
    tempo::UploadTime upload_time_;
    bool was_growing_ = false;
    int frames_waited_ = 0;
    int act_before_ = 0;
    base::Instant framed_at_{0};
    base::Instant shown_at_{0};        // the last frame, where the screen tells
    bool is_one_in_flight_ = false;    // handed over after that
    base::Instant handed_over_at_{0};  // on the screen's clock
    display::ShownFrames shown_frames_;
    std::optional<base::Instant> remembered_at_;
    int photographed_ = 0;  // the last act that was
    int round_ = 1;         // that is or was seen last
    int generations_ = 0;
    int finales_ = 0;
};

}  // namespace

RunEnd run_loop(const RunLoopParts& parts) { return Loop(parts).run(); }

}  // namespace quadrat::kiosk
