// SPDX-License-Identifier: Apache-2.0
#include "kiosk/announcer.hpp"

#include <utility>

#include "base/log.hpp"
#include "machine/service.hpp"
#include "tempo/memory.hpp"

namespace quadrat::kiosk {
namespace {

constexpr std::chrono::seconds kTimeToGrow{120};  // the next part of the first four; as TimeoutStartSec=

}  // namespace

void Announcer::presented(const display::Presented& presented, Show& show) {
    using display::Outcome;
    had_landscapes_ = !show.on_stage().scenes.empty();
    if (std::exchange(last_outcome_, presented.outcome) != presented.outcome) {
        if (presented.outcome == Outcome::Shown)
            base::log::info("screen: shows again");
        else if (presented.outcome == Outcome::Off)
            base::log::info("screen: {}", presented.reason);
        else
            base::log::warn("screen: {}", presented.reason);
    }
    if (presented.outcome != Outcome::Fault) tell_service(show);
}

void Announcer::decided(const tempo::Tempo& tempo, const std::string& gpu, Show& show, base::Instant now) {
    base::log::info("{}", tempo.plan().reason);
    // The plug may be pulled at any moment; once a minute is often enough for the disk.
    if (remembered_at_ && now - *remembered_at_ < std::chrono::minutes{1}) return;
    remembered_at_ = now;
    show.remember("detail", to_text(tempo.governor(), gpu));
}

// Ready is who has drawn landscapes once: the first such frame compiles what it is drawn with, which takes longer than
// the watchdog waits for a frame where the machine is slow. Until then there is time as long as they grow, and the
// watchdog is left alone: fed once, it bites before READY too.
void Announcer::tell_service(Show& show) {
    if (is_ready_) return machine::feed_watchdog();
    is_ready_ = had_landscapes_;
    if (is_ready_) return machine::announce_ready();
    const float progress = show.programme().progress();
    if (std::exchange(progress_, progress) != progress) machine::ask_for_time(kTimeToGrow);
}

}  // namespace quadrat::kiosk
