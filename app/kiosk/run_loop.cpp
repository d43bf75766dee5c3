// SPDX-License-Identifier: Apache-2.0
#include "kiosk/run_loop.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "base/log.hpp"
#include "hearing/hearing.hpp"
#include "kiosk/announcer.hpp"
#include "kiosk/captures.hpp"
#include "kiosk/gpu_measuring.hpp"
#include "kiosk/preview.hpp"
#include "kiosk/signals.hpp"
#include "kiosk/switchboard.hpp"
#include "machine/heap.hpp"
#include "tempo/memory.hpp"

namespace quadrat::kiosk {
namespace {

using exhibit::Screen;
using firmware_io::Motion;

// Of each frame, for what is brought to the GPU: by the clock (tempo::UploadSlices) for what this processor copies, by
// bytes for what the GPU does with it.
constexpr std::size_t kUploadBytes = 4U << 20U;
constexpr std::chrono::nanoseconds kUsualPeriod{16'666'667};  // where the display has none
constexpr std::chrono::seconds kLongestFrame{1};
constexpr int kWholeWidth = 1 << 15;  // pixels, or whatever the frame has less

class Loop {
  public:
    explicit Loop(const RunLoopParts& parts)
        : parts_(parts),
          theatre_(parts.configuration),
          captures_(parts),
          measuring_(parts),
          switchboard_(parts.configuration, parts.show),
          hearing_(parts.configuration, parts.seed,
                   parts.clock.is_simulated() ? hearing::Aloud::Told : hearing::Aloud::Played) {}

    RunEnd run() {
        parts_.show.open(parts_.clock.now());
        for (;;) {
            const base::Instant now = parts_.clock.now();
            tempo::HandOver how;
            how.begun = parts_.display.now();
            const display::Canvas canvas = parts_.display.begin_frame();
            theatre_.enter(canvas);
            // One frame ahead of the GPU is enough: more would be late, and take memory.
            if (!parts_.clock.is_simulated() && theatre_.is_drawn_within(kLongestFrame) && presented_)
                announcer_.drawn();
            hear(now);
            const base::DisplayTime uploading_since = parts_.display.now();
            const bool were_uploads_awaited = show_what_has_grown(now);
            if (parts_.record != nullptr) parts_.record->uploads_took.push_back(parts_.display.now() - uploading_since);
            const tempo::Plan& plan = plan_frame(canvas, were_uploads_awaited, now);
            how.drawing_since = parts_.display.now();
            if (!is_dark()) draw(canvas, now);
            how.drawn = drawn_at(how.begun);
            how.meant_periods = plan.periods;
            how.then = plan.then;
            how.not_before = plan.hand_over_at;
            presented_ = parts_.display.present(how);
            report(plan, now);
            if (const auto end = ending(*presented_)) return *end;
            pass_time(how.begun, now);
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
            if (parts_.caretaker != nullptr && parts_.caretaker->hear(edge, now))
                let_go(now);
            else
                pass_on(edge, now);
        }
        be_patient_while_speaking(now);
        parts_.show.happen(exhibit::Tick{}, now);
        switchboard_.look(now);
        listen(now);
        const auto lamps = parts_.caretaker != nullptr ? parts_.caretaker->lamps(now) : std::nullopt;
        parts_.panel.light(lamps.value_or(switchboard_.lamps()), now);
        if (parts_.caretaker == nullptr) return;
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
            switchboard_.hear(edge, now);
            edge.motion = Motion::Up;
        }
        switchboard_.hear(edge, now);
    }

    // Nobody is asked whether they are there while they are being told something.
    void be_patient_while_speaking(base::Instant now) {
        const bool is_speaking = hearing_.is_speaking(now);
        if (std::exchange(was_speaking_, is_speaking) || is_speaking) parts_.show.happen(exhibit::Stirred{}, now);
    }

    void listen(base::Instant now) {
        if (!hearing_.is_on()) return;
        if (parts_.caretaker != nullptr && parts_.caretaker->curtain() != site::Curtain::Open)
            return hearing_.be_silent(now);
        hearing_.look(switchboard_.heard(now), parts_.show.recipes_on_stage(), parts_.show.on_stage().number);
        switchboard_.wait_for_speech(hearing_.speaks() ? hearing_.speaks_until() : base::Instant{0});
    }

    void look_after(base::Instant now) {
        if (parts_.caretaker == nullptr) return;
        Show& show = parts_.show;
        const staff::Orders orders = parts_.caretaker->look(
            parts_.panel,
            {show.state().screen != Screen::Attract, show.visits_ended(), show.state_trouble(), hearing_.health()},
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
        if (presented_) {
            midst.period = presented_->period;
            midst.in_flight_since = presented_->in_flight_since;
            finished = presented_->finished;
        }
        midst.most_level = static_cast<float>(parts_.configuration.picture.alpha);
        midst.most_samples = theatre_.has_gpu() ? theatre_.most_samples() : 0;
        midst.pixels = static_cast<double>(canvas.size.width) * canvas.size.height;
        midst.triangles = drawn_.triangles;
        midst.act = parts_.show.on_stage().number;
        midst.is_growing = parts_.show.is_growing();
        midst.is_waited_for = parts_.show.state().screen == Screen::Breed;
        midst.were_uploads_awaited = were_uploads_awaited;
        midst.is_judged = !measuring_.takes_a_frame() && !is_dark();
        const tempo::Plan& plan = parts_.tempo.next(finished, midst);
        theatre_.set_detail({plan.fineness.alpha, plan.fineness.scale, plan.samples});
        if (!plan.reason.empty()) tell_decision(plan.reason, now);
        return plan;
    }

    void tell_decision(const std::string& why, base::Instant now) {
        base::log::info("{}", why);
        if (parts_.record != nullptr) parts_.record->decisions.push_back({now, why});
        // The plug may be pulled at any moment; once a minute is often enough for the disk.
        if (remembered_at_ && now - *remembered_at_ < std::chrono::minutes{1}) return;
        remembered_at_ = now;
        parts_.show.remember("detail", to_text(parts_.tempo.governor(), parts_.display.renderer()));
    }

    void draw(const display::Canvas& canvas, base::Instant now) {
        if (canvas.context != 0) captures_.keep(theatre_, canvas, now);
        if (!parts_.clock.is_simulated()) theatre_.rehearse(canvas);  // or no frame can come late
        measuring_.step(theatre_, canvas, now);
        draw_preview(canvas, now);
        stage::Theatre::Over over;
        if (parts_.caretaker != nullptr) over.board = parts_.caretaker->board();
        if (parts_.caretaker != nullptr) over.sign = parts_.caretaker->sign();
        if (parts_.keepsakes != nullptr && shows_earlier_landscapes()) over.backdrop = parts_.keepsakes->at(now);
        drawn_ = theatre_.draw(moment_of(parts_.show, switchboard_.scanned(now), now), canvas, over);
        if (parts_.caretaker == nullptr) return;
        take_picture(parts_.caretaker->take_picture_wish());
    }

    // A frame's time, when nobody is there to be kept waiting by it.
    void draw_preview(const display::Canvas& canvas, base::Instant now) {
        if (parts_.caretaker == nullptr || canvas.context == 0) return;
        const bool has_visitor = parts_.show.state().screen != Screen::Attract;
        const auto wish = parts_.caretaker->take_preview_wish(has_visitor);
        if (!wish) return;
        mesh::Image picture = preview_of(*wish, parts_.show, theatre_, parts_.configuration, canvas, now);
        if (picture.width > 0) parts_.caretaker->keep_picture(std::move(picture), staff::kPreview);
    }

    // What is asked for from afar comes without a wait; a fault is kept as it was just now.
    void take_picture(const std::string& file) {
        const bool is_from_afar = file == staff::kGlance || file == staff::kPicture;
        // Where none can be begun yet, it is wished for again.
        if (is_from_afar && theatre_.begin_glimpse(file == staff::kGlance ? staff::kGlanceWidth : kWholeWidth))
            glimpsed_ = file;
        else if (!file.empty() && !is_from_afar)
            parts_.caretaker->keep_picture(theatre_.read_back(), file);
        if (auto glimpse = theatre_.take_glimpse()) parts_.caretaker->keep_picture(std::move(*glimpse), glimpsed_);
    }

    // Waits no longer for the GPU than leaves time to hand the frame over. Nothing: it is not through by then.
    std::optional<base::DisplayTime> drawn_at(base::DisplayTime begun) {
        if (!parts_.tempo.is_governed()) return std::nullopt;
        const auto frame_time = period() * parts_.tempo.plan().periods;
        if (!theatre_.is_drawn_within(frame_time * 9 / 10 - (parts_.display.now() - begun))) return std::nullopt;
        return parts_.display.now();
    }

    std::chrono::nanoseconds period() const {
        return presented_ && presented_->period.count() > 0 ? presented_->period : kUsualPeriod;
    }

    // Before the first four have grown, and in safe mode as long as nobody is there.
    bool shows_earlier_landscapes() const {
        if (parts_.show.on_stage().scenes.empty()) return true;
        return parts_.mode == staff::Mode::Safe && parts_.show.state().screen == exhibit::Screen::Attract;
    }

    // True: somebody waits for what is brought to the GPU.
    bool show_what_has_grown(base::Instant now) {
        if (parts_.clock.is_simulated()) parts_.show.finish_growing();
        // While nothing is on stage, no frame can come late.
        const bool is_dark_yet = parts_.show.on_stage().scenes.empty();
        const bool is_all = parts_.clock.is_simulated() || is_dark_yet;
        const bool is_waited_for = is_all || parts_.show.waiting_for_upload() != nullptr;
        theatre_.set_awaited(is_waited_for);
        const tempo::UploadSlices& slices = parts_.tempo.plan().uploads;
        const auto slice = is_waited_for ? std::optional(slices.awaited) : slices.idle;
        if (slice) bring(parts_.display.now() + *slice, is_all, now);
        return is_waited_for;
    }

    // To the GPU, as much as there is time for.
    void bring(base::DisplayTime until, bool is_all, base::Instant now) {
        const stage::Theatre::Haste haste =
            is_all ? stage::Theatre::Haste::everything()
                   : stage::Theatre::Haste{kUploadBytes, [this, until] { return parts_.display.now() < until; }, 1};
        // What is on stage comes first: after a change of context it is missing too.
        if (!theatre_.prepare(parts_.show.on_stage(), haste)) return;
        const nursery::Act* act = parts_.show.waiting_for_upload();
        if (act != nullptr) {
            // A visitor waits for these, and their first light is painted quickly.
            stage::Theatre::Haste quick = haste;
            quick.scenes = static_cast<int>(act->scenes.size());
            if (!theatre_.prepare(*act, quick)) return;
            // A flush takes a millisecond or two where nothing is wrong, and a frame more would be seen.
            if (!parts_.show.is_kept_within(std::max(until - parts_.display.now(), std::chrono::nanoseconds{0})))
                return;
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

    void report(const tempo::Plan& plan, base::Instant now) {
        measuring_.has_period(period());
        if (parts_.caretaker != nullptr)
            parts_.caretaker->framed(*presented_, now,
                                     {plan.level, plan.fineness.alpha, plan.fineness.scale, drawn_.samples,
                                      plan.periods, drawn_.triangles, drawn_.draws, drawn_.objects});
        announcer_.presented(*presented_, parts_.show);
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
        std::optional<base::Instant> next;
        for (const auto& at :
             {parts_.buttons.next_event_at(), switchboard_.next_deadline(), hearing_.next_deadline(parts_.clock.now()),
              exhibit::next_deadline(parts_.show.state(), parts_.show.timings())})
            if (at) next = std::min(*at, next.value_or(*at));
        return next;
    }

    void pass_time(base::DisplayTime begun, base::Instant now) {
        if (parts_.clock.is_simulated()) {
            // A wish that was granted can change what comes next at once: never skip while something waits.
            parts_.clock.skip_to(std::max(now + std::chrono::milliseconds{1}, next_moment().value_or(now)));
            return;
        }
        if (presented_->period.count() > 0 && presented_->outcome == display::Outcome::Shown) return;
        std::this_thread::sleep_for(kUsualPeriod * parts_.tempo.plan().periods - (parts_.display.now() - begun));
    }

    const RunLoopParts& parts_;
    stage::Theatre theatre_;
    Captures captures_;
    Announcer announcer_;
    GpuMeasuring measuring_;
    Switchboard switchboard_;
    hearing::Hearing hearing_;
    std::optional<display::Presented> presented_;  // the last frame; nothing before it
    render::Drawn drawn_;                          // last
    display::Power power_ = display::Power::On;
    std::string glimpsed_;         // the file of the picture that is on its way
    bool has_given_back_ = false;  // what the first landscapes took, once they were there
    bool wants_to_quit_ = false;
    bool was_speaking_ = false;
    std::optional<base::Instant> remembered_at_;
};

}  // namespace

RunEnd run_loop(const RunLoopParts& parts) { return Loop(parts).run(); }

}  // namespace quadrat::kiosk
