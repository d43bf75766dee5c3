// SPDX-License-Identifier: Apache-2.0
#include "tempo/upload_slice.hpp"

#include <algorithm>

namespace quadrat::tempo {

void UploadSlice::drew(nanoseconds took) { drew_[frames_++ % drew_.size()] = took; }

UploadSlices UploadSlice::next(nanoseconds frame_time) const {
    UploadSlices slices;
    slices.awaited = frame_time / kShare;
    const nanoseconds share = std::min(slices.awaited, kMost);
    // A tenth stays free.
    const nanoseconds left = frame_time * 9 / 10 - *std::ranges::max_element(drew_) - kPiece;
    if (put_off_ >= kMostPutOff)
        slices.idle = share;
    else if (left > nanoseconds{0})
        slices.idle = std::min(share, left);
    return slices;
}

void UploadSlice::used(const UploadSlices& slices, bool was_awaited) {
    put_off_ = was_awaited || slices.idle ? 0 : put_off_ + 1;
}

}  // namespace quadrat::tempo
