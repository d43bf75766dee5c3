// SPDX-License-Identifier: Apache-2.0
#include "tempo/frame_record.hpp"

namespace quadrat::tempo {

nanoseconds took(const FrameRecord& record) {
    return record.shown_before ? record.shown - *record.shown_before : nanoseconds{0};
}

nanoseconds frame_time(const FrameRecord& record) { return record.period * record.meant_periods; }

bool is_late(nanoseconds took, nanoseconds period, int meant_periods) {
    return period.count() > 0 && took > period * meant_periods + period / 2;
}

bool is_late(const FrameRecord& record) { return is_late(took(record), record.period, record.meant_periods); }

}  // namespace quadrat::tempo
