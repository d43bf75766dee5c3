// SPDX-License-Identifier: Apache-2.0
#include "kiosk/upload_time.hpp"

#include <algorithm>

namespace quadrat::kiosk {

void UploadTime::drew(Instant took) { drew_[frames_++ % drew_.size()] = took; }

std::optional<Instant> UploadTime::next(Instant frame_time, bool is_waited_for) {
    const Instant share = is_waited_for ? frame_time / kShare : std::min(frame_time / kShare, kMost);
    // A tenth stays free.
    const Instant left = frame_time * 9 / 10 - *std::ranges::max_element(drew_) - kPiece;
    const bool is_due = is_waited_for || put_off_ >= kMostPutOff;
    if (!is_due && left <= Instant{0}) {
        ++put_off_;
        return std::nullopt;
    }
    put_off_ = 0;
    return is_due ? share : std::min(share, left);
}

}  // namespace quadrat::kiosk
