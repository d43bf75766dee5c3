// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "display/kms/atomic_output.hpp"
#include "display/kms/card_choice.hpp"
#include "display/kms/drm_card.hpp"
#include "display/kms/gbm_target.hpp"
#include "display/kms/mode_choice.hpp"
#include "display/kms/screen_hardware.hpp"
#include "display/kms/uevent.hpp"

namespace quadrat::display {

// The machine's own cards and cables, as the screen's keeper asks for them.
class DrmHardware final : public ScreenHardware {
  public:
    explicit DrmHardware(const DisplayOptions& options);
    ~DrmHardware() override { close_card(); }

    // What the next frame is drawn into, its context current. Without rotation and the like.
    Canvas canvas();
    std::string description() const;
    std::string renderer() const { return target_ ? target_->renderer() : ""; }  // "" before there is a GPU
    bool is_denied() const { return is_denied_; }  // the last probe found a card that is not ours to use

    Instant now() override;
    std::vector<News> wait(Instant at_most) override;
    ProbeResult probe() override;
    std::optional<event::PlugMoved> glance() override;
    Refusal modeset(int rung) override;
    void disable() override;
    void close_card() override;
    std::optional<Refusal> flip() override;
    Instant period() const override { return period_; }

  private:
    ProbeResult probe_every_card();
    bool open_target(std::string& why);
    ScreenFound remember(const Connector& connector);
    const Connector* present_connector() const;
    Refusal show_first(const drmModeModeInfo& mode, Size draw, const std::vector<std::uint64_t>& modifiers);
    void drop_frames();
    void take_flips(std::vector<News>& news);
    void take_plugs(std::vector<News>& news);

    DisplayOptions options_;
    std::optional<WantedMode> wanted_mode_;
    UeventSocket uevents_;
    std::unique_ptr<DrmCard> card_;
    std::unique_ptr<GbmTarget> target_;
    std::optional<AtomicOutput> output_;
    std::uint32_t connector_ = 0;
    std::uint64_t edid_ = 0;
    std::string connector_name_;
    ModeLadder ladder_;
    std::string mode_name_;
    Instant period_{0};
    std::string warned_;  // of a configured connector that no card has, last
    bool is_denied_ = false;
    bool is_lit_ = false;
    std::optional<Scanout> drawn_;  // offered, and refused as busy
    std::optional<Scanout> in_flight_;
    std::optional<Scanout> shown_;
};

}  // namespace quadrat::display
