// SPDX-License-Identifier: Apache-2.0
#include "kiosk/gpu_measuring.hpp"

#include "base/log.hpp"
#include "tempo/memory.hpp"

namespace quadrat::kiosk {
namespace {

constexpr std::chrono::seconds kUntilCalm{5};  // landscapes have grown in, and were looked at
constexpr int kFramesDisturbed = 3;            // by one step

}  // namespace

void GpuMeasuring::step(stage::Theatre& theatre, const display::Canvas& canvas, base::Instant now) {
    const bool is_over = benchmark_ && benchmark_->is_over();
    if (!parts_.calibrates || is_over || !parts_.tempo.is_governed() || !theatre.has_gpu()) return;
    const nursery::Act& act = parts_.show.on_stage();
    const bool is_calm = parts_.show.state().screen == exhibit::Screen::Attract &&
                         !parts_.show.programme().is_growing() && act.scenes.size() == genome::kCandidates &&
                         now - act.arrived > kUntilCalm;
    if (!is_calm || !canvas.is_seen) return;
    if (!benchmark_) benchmark_.emplace(theatre.most_samples());
    frames_disturbed_ = kFramesDisturbed;
    const std::optional<tempo::GpuProfile> profile = theatre.try_out(*benchmark_, act, canvas);
    if (!profile) return;
    const double period_ms = std::chrono::duration<double, std::milli>(period_).count();
    const auto most = static_cast<float>(parts_.configuration.picture.alpha);
    parts_.tempo.begin_anew(start_for(*profile, most, period_ms));
    const tempo::DetailGovernor& governor = parts_.tempo.governor();
    base::log::info("GPU: {}; detail {:.2f}{}", to_text(*profile), governor.settled(),
                    governor.samples() > 1 ? ", smooth edges" : "");
    const std::string gpu = parts_.display.renderer();
    parts_.show.remember("gpu", to_text(*profile, gpu));
    parts_.show.remember("detail", to_text(governor, gpu));
}

}  // namespace quadrat::kiosk
