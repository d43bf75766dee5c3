// SPDX-License-Identifier: Apache-2.0
#include "tempo/upload_time.hpp"

#include <algorithm>

namespace quadrat::tempo {

void UploadTime::drew(base::Instant took) { drew_[frames_++ % drew_.size()] = took; }

std::optional<base::Instant> UploadTime::next(base::Instant frame_time, bool is_waited_for) {
    const base::Instant share = is_waited_for ? frame_time / kShare : std::min(frame_time / kShare, kMost);
    // A tenth stays free.
    const base::Instant left = frame_time * 9 / 10 - *std::ranges::max_element(drew_) - kPiece;
    const bool is_due = is_waited_for || put_off_ >= kMostPutOff;
    if (!is_due && left <= base::Instant{0}) {
        ++put_off_;
        return std::nullopt;
    }
    put_off_ = 0;
    return is_due ? share : std::min(share, left);
}

}  // namespace quadrat::tempo
