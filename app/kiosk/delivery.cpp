// SPDX-License-Identifier: Apache-2.0
#include "kiosk/delivery.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "machine/heap.hpp"

namespace quadrat::kiosk {
namespace {

using stage::OnGpu;

// Of each frame: by the clock (tempo::UploadSlices) for what this processor copies, by bytes for what the GPU does with
// it.
constexpr std::size_t kUploadBytes = 4U << 20U;

}  // namespace

bool Delivery::look(base::Instant now) {
    const base::DisplayTime since = parts_.display.now();
    if (passage_.waits_for_all()) parts_.show.finish_growing();
    // While nothing is on stage, no frame can come late.
    const bool is_dark_yet = parts_.show.on_stage().scenes.empty();
    const bool is_all = passage_.waits_for_all() || is_dark_yet;
    const bool is_waited_for = is_all || parts_.show.programme().waiting_for_upload() != nullptr;
    if (theatre_.has_gpu()) theatre_.on_gpu().set_awaited(is_waited_for);
    const tempo::UploadSlices& slices = parts_.tempo.plan().uploads;
    const auto slice = is_waited_for ? std::optional(slices.awaited) : slices.idle;
    if (slice) bring(parts_.display.now() + *slice, is_all, now);
    parts_.watcher->uploaded_for(parts_.display.now() - since);
    return is_waited_for;
}

void Delivery::bring(base::DisplayTime until, bool is_all, base::Instant now) {
    Programme& programme = parts_.show.programme();
    const nursery::Act* coming = programme.waiting_for_upload();
    const nursery::Act* refined = programme.waiting_to_refine();
    // What is on stage comes first: after a change of context it is missing too.
    OnGpu::Wanted wanted{{{parts_.show.on_stage().scenes}}};
    // A visitor waits for these, and their first light is painted quickly.
    if (coming != nullptr) wanted.batches.push_back({coming->scenes, true});
    if (refined != nullptr) wanted.batches.push_back({refined->scenes});
    wanted.held = programme.in_use();
    nursery::Prospect ahead = programme.ahead();
    if (wanted.batches.size() == 1)
        wanted.ahead = std::move(ahead);
    else
        std::ranges::move(ahead.lit, std::back_inserter(wanted.held));
    if (theatre_.has_gpu())
        theatre_.on_gpu().bring(
            wanted, is_all ? OnGpu::Haste::everything()
                           : OnGpu::Haste{kUploadBytes, [this, until] { return parts_.display.now() < until; }});
    if (!theatre_.has(parts_.show.on_stage())) return;
    if (coming != nullptr && theatre_.has(*coming)) return show(until, now);
    if (refined != nullptr && theatre_.has(*refined)) programme.note_refined();
}

// What was waited for, once it is kept.
void Delivery::show(base::DisplayTime until, base::Instant now) {
    // A flush takes a millisecond or two where nothing is wrong, and a frame more would be seen.
    if (!parts_.show.is_kept_within(std::max(until - parts_.display.now(), std::chrono::nanoseconds{0}))) return;
    parts_.show.uploaded(now);
    if (!std::exchange(has_given_back_, true)) machine::give_memory_back();
}

}  // namespace quadrat::kiosk
