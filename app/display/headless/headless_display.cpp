// SPDX-License-Identifier: Apache-2.0
#include "display/headless/headless_display.hpp"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "base/log.hpp"
#include "display/egl/offscreen_target.hpp"
#include "display/monotonic.hpp"
#include "display/options.hpp"
#include "tempo/flight_log.hpp"

namespace quadrat::display {
namespace {

constexpr Size kUsualSize{1280, 720};

class HeadlessDisplay final : public Display {
  public:
    HeadlessDisplay(const DisplayOptions& options, std::string why, std::shared_ptr<EglScreen> screen,
                    EglContext context)
        : Display(std::move(why)), options_(options), screen_(std::move(screen)) {
        context_.emplace(std::move(context));
        target_.emplace(options.size == Size{} ? kUsualSize : options.size);
        renderer_ = renderer_name();
    }
    ~HeadlessDisplay() override {
        if (context_) context_->make_current();  // so that the target's names are deleted in it
    }

    std::string_view kind() const override { return "headless"; }
    std::string description() const override {
        const Size size = canvas().size;
        return fmt::format("{}, {}x{} without a screen", renderer_, size.width, size.height);
    }
    std::string renderer() const override { return renderer_; }
    Canvas canvas() const override {
        if (!context_) return {};
        return {context_->number(), target_->framebuffer(), target_->size(),
                options_.rotation,  options_.mirroring,     power_ == Power::On};
    }
    Canvas begin_frame() override {
        if (context_) context_->make_current();
        if (context_ && context_->is_lost()) begin_anew();
        return canvas();
    }
    Presented present(const tempo::HandOver& how) override {
        if (!context_) return told(Outcome::Fault, {}, "the GPU was reset, and does not start again");
        ++frame_;
        if (options_.paces.empty())
            glFlush();
        else
            take_as_a_screen_would(how);
        if (power_ == Power::Off) return told(Outcome::Off, {}, "switched off");
        if (!options_.paces.empty()) return told(Outcome::Shown, period(), "");
        flights_.handed_over(frame_, how, display_now());
        shown_frame_ = frame_;
        shown_at_ = monotonic_now();
        flights_.shown(base::DisplayTime{shown_at_}, {});
        return told(Outcome::Shown, {}, "");
    }
    void set_power(Power power) override { power_ = power; }

  private:
    using Instant = std::chrono::nanoseconds;

    Instant period() const {
        const Pace* now = &options_.paces.front();
        for (const Pace& pace : options_.paces)
            if (refreshed_at_ >= began_at_ + pace.from) now = &pace;
        return Instant{static_cast<Instant::rep>(1e9 / now->hz)};
    }
    Presented told(Outcome outcome, Instant period, const char* reason) {
        return {outcome,
                shown_frame_,
                base::DisplayTime{shown_at_},
                period,
                reason,
                flights_.take_finished(),
                flights_.in_flight_since()};
    }
    // At the first refresh after it was drawn, and the frame before it was shown.
    void take_as_a_screen_would(const tempo::HandOver& how) {
        glFinish();
        wait_for_flip();
        if (how.not_before)
            std::this_thread::sleep_until(std::chrono::steady_clock::time_point{how.not_before->time_since_epoch()});
        const Instant now = monotonic_now();
        refreshed_at_ += ((now - refreshed_at_) / period() + 1) * period();
        is_in_flight_ = true;
        frame_in_flight_ = frame_;
        flights_.handed_over(frame_, how, base::DisplayTime{now});
        if (how.then == tempo::HandOver::Then::Wait) wait_for_flip();
    }
    void wait_for_flip() {
        if (!std::exchange(is_in_flight_, false)) return;
        std::this_thread::sleep_until(std::chrono::steady_clock::time_point{refreshed_at_});
        if (power_ == Power::Off) return flights_.interrupted();
        shown_frame_ = frame_in_flight_;
        shown_at_ = refreshed_at_;
        flights_.shown(base::DisplayTime{shown_at_}, period());
    }
    void begin_anew() {
        const Size size = target_->size();
        base::log::warn("display: the GPU was reset; its context is made anew");
        target_.reset();
        context_.reset();
        std::string why;
        auto context = EglContext::open(screen_, std::nullopt, why);
        if (!context) return;
        context_.emplace(std::move(*context));
        target_.emplace(size);
    }

    DisplayOptions options_;
    std::shared_ptr<EglScreen> screen_;
    std::optional<EglContext> context_;  // nothing: lost, and it could not be made anew
    std::optional<OffscreenTarget> target_;
    std::string renderer_;
    Power power_ = Power::On;
    std::uint64_t frame_ = 0;
    std::uint64_t shown_frame_ = 0;
    Instant shown_at_{0};
    Instant began_at_ = monotonic_now();
    Instant refreshed_at_ = began_at_;  // or will be, where a frame is in flight
    tempo::FlightLog flights_;
    bool is_in_flight_ = false;
    std::uint64_t frame_in_flight_ = 0;
};

}  // namespace

std::unique_ptr<Display> open_headless(const DisplayOptions& options, std::string why,
                                       const std::vector<HeadlessPlatform>& platforms) {
    check(options);
    std::string reasons;
    for (const HeadlessPlatform platform : platforms) {
        for (const auto& screen : headless_screens(platform)) {
            std::string reason;
            if (auto context = EglContext::open(screen, std::nullopt, reason))
                return std::make_unique<HeadlessDisplay>(options, std::move(why), screen, std::move(*context));
            reasons += (reasons.empty() ? "" : "; ") + reason;
        }
    }
    throw base::InputError(
        fmt::format("headless display: no OpenGL ES 3.1 here ({}); install a driver: apt install libegl1 libegl-mesa0 "
                    "libgl1-mesa-dri",
                    reasons.empty() ? "EGL offers neither a surfaceless nor a device platform" : reasons));
}

}  // namespace quadrat::display
