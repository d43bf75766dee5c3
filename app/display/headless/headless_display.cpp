// SPDX-License-Identifier: Apache-2.0
#include "display/headless/headless_display.hpp"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include <utility>

#include "base/error.hpp"
#include "display/egl/offscreen_target.hpp"
#include "display/monotonic.hpp"
#include "display/options.hpp"

namespace quadrat::display {
namespace {

constexpr Size kUsualSize{1280, 720};

class HeadlessDisplay final : public Display {
  public:
    HeadlessDisplay(const DisplayOptions& options, std::string why, EglContext context)
        : Display(std::move(why)),
          options_(options),
          context_(std::move(context)),
          target_(options.size == Size{} ? kUsualSize : options.size),
          renderer_(renderer_name()) {}
    ~HeadlessDisplay() override { context_.make_current(); }  // so that the target's names are deleted in it

    std::string_view kind() const override { return "headless"; }
    std::string description() const override {
        return fmt::format("{}, {}x{} without a screen", renderer_, target_.size().width, target_.size().height);
    }
    Canvas canvas() const override {
        return {context_.number(), target_.framebuffer(), target_.size(),
                options_.rotation, options_.mirroring,    power_ == Power::On};
    }
    Canvas begin_frame() override {
        context_.make_current();
        return canvas();
    }
    Presented present() override {
        glFlush();
        ++frame_;
        const auto now = monotonic_now();
        if (power_ == Power::Off) return {Outcome::Off, shown_frame_, shown_at_, {}, "switched off"};
        shown_frame_ = frame_;
        shown_at_ = now;
        return {Outcome::Shown, shown_frame_, shown_at_, {}, {}};
    }
    void set_power(Power power) override { power_ = power; }

  private:
    DisplayOptions options_;
    EglContext context_;
    OffscreenTarget target_;
    std::string renderer_;
    Power power_ = Power::On;
    std::uint64_t frame_ = 0;
    std::uint64_t shown_frame_ = 0;
    std::chrono::nanoseconds shown_at_{0};
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
                return std::make_unique<HeadlessDisplay>(options, std::move(why), std::move(*context));
            reasons += (reasons.empty() ? "" : "; ") + reason;
        }
    }
    throw base::InputError(
        fmt::format("headless display: no OpenGL ES 3.1 here ({}); install a driver: apt install libegl1 libegl-mesa0 "
                    "libgl1-mesa-dri",
                    reasons.empty() ? "EGL offers neither a surfaceless nor a device platform" : reasons));
}

}  // namespace quadrat::display
