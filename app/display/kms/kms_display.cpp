// SPDX-License-Identifier: Apache-2.0
#include "display/kms/kms_display.hpp"

#include <fmt/core.h>

#include <optional>

#include "base/error.hpp"
#include "base/log.hpp"
#include "display/kms/console.hpp"
#include "display/kms/drm_hardware.hpp"
#include "display/kms/screen_keeper.hpp"
#include "display/options.hpp"

namespace quadrat::display {
namespace {

class KmsDisplay final : public Display {
  public:
    KmsDisplay(const DisplayOptions& options, std::string why)
        : Display(std::move(why)), options_(options), hardware_(options), keeper_(hardware_) {
        keeper_.attend();
        canvas_ = dressed(hardware_.canvas());
    }
    // Off before the card is closed, and the card closed before the console comes back, which then draws itself anew.
    ~KmsDisplay() override { hardware_.disable(); }

    Phase phase() const { return keeper_.state().phase; }
    const std::string& reason() const { return keeper_.state().reason; }
    bool is_denied() const { return hardware_.is_denied(); }
    // As soon as there is a card, screen or not: what is typed on a keyboard encoder is not for a shell.
    void take_console() {
        if (console_ || phase() == Phase::NoCard) return;
        console_.emplace(Console::take());
        if (!console_->problem().empty()) base::log::warn("screen: {}", console_->problem());
    }

    std::string_view kind() const override { return "kms"; }
    std::string description() const override { return hardware_.description(); }
    std::string renderer() const override { return hardware_.renderer(); }
    Canvas canvas() const override { return canvas_; }
    Canvas begin_frame() override {
        keeper_.attend();
        take_console();
        return canvas_ = dressed(hardware_.canvas());
    }
    Presented present(const tempo::HandOver& how) override { return keeper_.present(how); }
    void set_power(Power power) override { keeper_.set_power(power); }

  private:
    Canvas dressed(Canvas canvas) const {
        canvas.rotation = options_.rotation;
        canvas.mirroring = options_.mirroring;
        return canvas;
    }

    DisplayOptions options_;
    std::optional<Console> console_;  // outlives the card
    DrmHardware hardware_;
    ScreenKeeper keeper_;
    Canvas canvas_;
};

}  // namespace

std::unique_ptr<Display> open_kms(const DisplayOptions& options, std::string why) {
    check(options);
    auto display = std::make_unique<KmsDisplay>(options, std::move(why));
    if (display->phase() == Phase::NoCard && display->is_denied())
        throw base::InputError("kms display: " + display->reason());
    display->take_console();
    return display;
}

std::unique_ptr<Display> open_kms_if_there_is_a_screen(const DisplayOptions& options, std::string& why_not) {
    check(options);
    if (card_paths().empty()) {
        why_not = "no graphics card in /dev/dri";
        return nullptr;
    }
    auto display = std::make_unique<KmsDisplay>(options, "the screen itself, as there is one and it is ours");
    if (display->phase() == Phase::Running) {
        display->take_console();
        return display;
    }
    why_not = display->reason();
    return nullptr;
}

}  // namespace quadrat::display
