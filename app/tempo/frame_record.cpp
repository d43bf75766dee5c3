// SPDX-License-Identifier: Apache-2.0
#include "tempo/frame_record.hpp"

namespace quadrat::tempo {

nanoseconds took(const FrameRecord& record) {
    return record.shown_before ? record.shown - *record.shown_before : nanoseconds{0};
}

nanoseconds frame_time(const FrameRecord& record) { return record.period * record.meant_periods; }

bool is_late(const FrameRecord& record) {
    return record.period.count() > 0 && took(record) > frame_time(record) + record.period / 2;
}

}  // namespace quadrat::tempo
