// SPDX-License-Identifier: Apache-2.0
#include "kiosk/run_loop.hpp"

#include <algorithm>
#include <utility>

#include "base/log.hpp"
#include "hearing/hearing.hpp"
#include "kiosk/announcer.hpp"
#include "kiosk/captures.hpp"
#include "kiosk/delivery.hpp"
#include "kiosk/gpu_measuring.hpp"
#include "kiosk/passage.hpp"
#include "kiosk/signals.hpp"
#include "kiosk/switchboard.hpp"

namespace quadrat::kiosk {
namespace {

using exhibit::Screen;
using firmware_io::Motion;

constexpr std::chrono::nanoseconds kUsualPeriod{16'666'667};  // where the display has none
constexpr std::chrono::seconds kLongestFrame{1};

class Loop {
  public:
    explicit Loop(const RunLoopParts& parts)
        : parts_(parts),
          passage_(passage_of(parts.clock)),
          theatre_(parts.configuration,
                   passage_->waits_for_all() ? stage::Theatre::Frames::AtAnyTime : stage::Theatre::Frames::InTime),
          delivery_(parts, *passage_, theatre_),
          captures_(parts),
          measuring_(parts),
          switchboard_(parts.configuration, parts.show),
          hearing_(parts.configuration, parts.seed,
                   passage_->waits_for_all() ? hearing::Aloud::Told : hearing::Aloud::Played) {}

    RunEnd run() {
        parts_.show.open(parts_.clock.now());
        for (;;) {
            const base::Instant now = parts_.clock.now();
            tempo::HandOver how;
            how.begun = parts_.display.now();
            const display::Canvas canvas = parts_.display.begin_frame();
            theatre_.enter(canvas);
            // One frame ahead of the GPU is enough: more would be late, and take memory.
            if (!passage_->waits_for_all() && theatre_.is_drawn_within(kLongestFrame) && last_.presented)
                announcer_.drawn();
            take_presses(now);
            const bool were_uploads_awaited = delivery_.look(now);
            const tempo::Plan& plan = plan_frame(canvas, were_uploads_awaited, now);
            how.drawing_since = parts_.display.now();
            if (!is_dark()) draw(canvas, now);
            how.drawn = drawn_at(how.begun);
            how.meant_periods = plan.periods;
            how.then = plan.then;
            how.not_before = plan.hand_over_at;
            last_.presented = parts_.display.present(how);
            report(plan, now);
            if (const auto end = ending(*last_.presented)) return *end;
            pass_time(how.begun, now);
        }
    }

  private:
    bool is_dark() const {
        return parts_.attendant->curtain() == site::Curtain::Dark && parts_.attendant->board() == nullptr;
    }

    void take_presses(base::Instant now) {
        for (const display::KeyMotion& key : parts_.display.take_keys()) {
            if (key.key == display::Key::Escape || key.key == display::Key::Q) wants_to_quit_ = true;
            if (key.key == display::Key::F1 && key.move == display::KeyMove::Down) parts_.attendant->step_figures();
            const Motion motion = key.move == display::KeyMove::Down ? Motion::Down : Motion::Up;
            if (key_of(key.key) != 0) parts_.buttons.key(key_of(key.key), motion, now);
        }
        const auto edges = parts_.panel.poll(now);
        look_after(now);
        for (const firmware_io::ButtonEdge& edge : edges) {
            if (parts_.attendant->take_edge(edge, now))
                let_go(now);
            else
                pass_on(edge, now);
        }
        be_patient_while_speaking(now);
        parts_.show.happen(exhibit::Tick{}, now);
        switchboard_.look(now);
        listen(now);
        parts_.panel.light(parts_.attendant->lamps(now).value_or(switchboard_.lamps()), now);
        const display::Power power = is_dark() ? display::Power::Off : display::Power::On;
        if (power != power_) parts_.display.set_power(power_ = power);
    }

    void let_go(base::Instant now) {
        switchboard_.let_go(now);
        hearing_.let_go();
    }

    // Where the exhibit speaks, Back may be held for it to speak again. Where any press will do, it is one at once.
    bool may_be_held(const firmware_io::ButtonEdge& edge) const {
        const Screen screen = parts_.show.state().screen;
        const bool is_one_of_any = screen == Screen::Attract || screen == Screen::StillThere;
        return edge.button == firmware_io::Button::Back && switchboard_.has_four_buttons() &&
               (edge.motion == Motion::Up || !is_one_of_any);
    }

    void pass_on(firmware_io::ButtonEdge edge, base::Instant now) {
        using Passes = hearing::Hearing::Passes;
        const bool is_down = edge.motion == Motion::Down;
        const Passes passes = may_be_held(edge) ? hearing_.hear_back(is_down, now) : Passes::AsItIs;
        if (passes == Passes::Nothing) return parts_.show.happen(exhibit::Stirred{}, now);
        if (passes == Passes::WholePress) {
            edge.motion = Motion::Down;
            switchboard_.take_edge(edge, now);
            edge.motion = Motion::Up;
        }
        switchboard_.take_edge(edge, now);
    }

    // Nobody is asked whether they are there while they are being told something.
    void be_patient_while_speaking(base::Instant now) {
        if (hearing_.has_spoken(now)) parts_.show.happen(exhibit::Stirred{}, now);
    }

    void listen(base::Instant now) {
        if (!hearing_.is_on()) return;
        if (parts_.attendant->curtain() != site::Curtain::Open) return hearing_.be_silent(now);
        hearing_.look(switchboard_.heard(now), parts_.show.recipes_on_stage(), parts_.show.on_stage().number);
        switchboard_.wait_for_speech(hearing_.speaks() ? hearing_.speaks_until() : base::Instant{0});
    }

    void look_after(base::Instant now) {
        Show& show = parts_.show;
        const staff::Orders orders =
            parts_.attendant->look(parts_.panel,
                                   {show.state().screen != Screen::Attract, show.visits_ended(), show.state_trouble(),
                                    [this] { return hearing_.health(); }},
                                   now);
        if (orders.follows_settings) {
            show.follow(parts_.configuration);
            hearing_.follow();
        }
        if (orders.buttons_memory) show.remember("buttons", *orders.buttons_memory);
    }

    // By how the frames went that were shown since the last one was planned.
    const tempo::Plan& plan_frame(const display::Canvas& canvas, bool were_uploads_awaited, base::Instant now) {
        tempo::Circumstances midst;
        midst.now = parts_.display.now();
        std::span<const tempo::FrameRecord> finished;
        if (last_.presented) {
            midst.period = last_.presented->period;
            midst.in_flight_since = last_.presented->in_flight_since;
            finished = last_.presented->finished;
        }
        midst.most_level = static_cast<float>(parts_.configuration.picture.alpha);
        midst.most_samples = theatre_.has_gpu() ? theatre_.most_samples() : 0;
        midst.pixels = static_cast<double>(canvas.size.width) * canvas.size.height;
        midst.triangles = last_.drawn.triangles;
        midst.act = parts_.show.on_stage().number;
        midst.is_growing = parts_.show.programme().is_growing();
        midst.is_waited_for = parts_.show.state().screen == Screen::Breed;
        midst.were_uploads_awaited = were_uploads_awaited;
        midst.is_judged = !measuring_.takes_a_frame() && !is_dark();
        const tempo::Plan& plan = parts_.tempo.next(finished, midst);
        theatre_.set_detail({plan.fineness.alpha, plan.fineness.scale, plan.samples});
        if (!plan.reason.empty()) {
            parts_.watcher->decided(now, plan.reason);
            announcer_.decided(parts_.tempo, parts_.display.renderer(), parts_.show, now);
        }
        return plan;
    }

    void draw(const display::Canvas& canvas, base::Instant now) {
        if (canvas.context != 0) captures_.keep(theatre_, canvas, now);
        if (!passage_->waits_for_all()) theatre_.rehearse(canvas);  // or no frame can come late
        measuring_.step(theatre_, canvas, now);
        captures_.draw_preview(theatre_, canvas, now);
        if (parts_.show.take_postcard_wish())
            parts_.attendant->wish_postcard(parts_.show.caption(), parts_.show.take_home(),
                                            parts_.show.shown_language(now));
        parts_.attendant->look_at_postcards(theatre_, parts_.show.programme().act_of(Screen::Finale), canvas);
        stage::Theatre::Over over;
        over.board = parts_.attendant->board();
        over.sign = parts_.attendant->sign();
        if (shows_earlier_landscapes()) over.backdrop = parts_.keepsakes->at(now);
        last_.drawn = theatre_.draw(moment_of(parts_.show, switchboard_.scanned(now), now), canvas, over);
        captures_.answer(theatre_);
    }

    // Waits no longer for the GPU than leaves time to hand the frame over. Nothing: it is not through by then.
    std::optional<base::DisplayTime> drawn_at(base::DisplayTime begun) {
        if (!parts_.tempo.is_governed()) return std::nullopt;
        const auto frame_time = period() * parts_.tempo.plan().periods;
        if (!theatre_.is_drawn_within(frame_time * 9 / 10 - (parts_.display.now() - begun))) return std::nullopt;
        return parts_.display.now();
    }

    std::chrono::nanoseconds period() const {
        return last_.presented && last_.presented->period.count() > 0 ? last_.presented->period : kUsualPeriod;
    }

    // Before the first four have grown, and in safe mode as long as nobody is there.
    bool shows_earlier_landscapes() const {
        if (parts_.show.on_stage().scenes.empty()) return true;
        return parts_.mode == staff::Mode::Safe && parts_.show.state().screen == exhibit::Screen::Attract;
    }

    void report(const tempo::Plan& plan, base::Instant now) {
        measuring_.has_period(period());
        const render::Drawn& drawn = last_.drawn;
        parts_.attendant->framed(*last_.presented, now,
                                 {plan.level, plan.fineness.alpha, plan.fineness.scale, drawn.samples, plan.periods,
                                  drawn.triangles, drawn.draws, drawn.objects});
        announcer_.presented(*last_.presented, parts_.show);
    }

    std::optional<RunEnd> ending(const display::Presented& presented) const {
        if (parts_.stop->load()) return RunEnd::Stopped;
        if (wants_to_quit_ || parts_.display.wants_to_close()) return RunEnd::WindowClosed;
        if (presented.outcome == display::Outcome::Fault) return RunEnd::DisplayFault;
        if (parts_.attendant->wants_restart()) return RunEnd::Restart;
        if (parts_.ends_after_visit && parts_.show.visits_ended() > 0) return RunEnd::VisitOver;
        const bool is_script_over = passage_->waits_for_all() && parts_.buttons.is_finished() &&
                                    parts_.show.state().screen == exhibit::Screen::Attract &&
                                    !next_moment().has_value();
        if (is_script_over) return RunEnd::ScriptOver;
        return std::nullopt;
    }

    // When something will happen by itself.
    std::optional<base::Instant> next_moment() const {
        std::optional<base::Instant> next;
        for (const auto& at :
             {parts_.buttons.next_event_at(), switchboard_.next_deadline(), hearing_.next_deadline(parts_.clock.now()),
              exhibit::next_deadline(parts_.show.state(), parts_.show.timings())})
            if (at) next = std::min(*at, next.value_or(*at));
        return next;
    }

    // A display that shows frames sets the pace by itself.
    void pass_time(base::DisplayTime begun, base::Instant now) {
        const bool is_paced =
            last_.presented->period.count() > 0 && last_.presented->outcome == display::Outcome::Shown;
        const auto rest = kUsualPeriod * parts_.tempo.plan().periods - (parts_.display.now() - begun);
        passage_->pass(now, next_moment(), is_paced ? std::chrono::nanoseconds{0} : rest);
    }

    struct LastFrame {
        std::optional<display::Presented> presented;  // nothing before the first
        render::Drawn drawn;
    };

    const RunLoopParts& parts_;
    std::unique_ptr<Passage> passage_;
    stage::Theatre theatre_;
    Delivery delivery_;
    Captures captures_;
    Announcer announcer_;
    GpuMeasuring measuring_;
    Switchboard switchboard_;
    hearing::Hearing hearing_;
    LastFrame last_;
    display::Power power_ = display::Power::On;
    bool wants_to_quit_ = false;
};

}  // namespace

RunEnd run_loop(const RunLoopParts& parts) { return Loop(parts).run(); }

}  // namespace quadrat::kiosk
