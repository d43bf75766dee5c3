// SPDX-License-Identifier: Apache-2.0
#include "kiosk/heap.hpp"

#include <malloc.h>

namespace quadrat::kiosk {

void give_memory_back() {
    constexpr int kArenas = 2;
    // Pictures, lands: each its own mapping, gone when it is freed. A software rasteriser's blocks of 64 KB stay in the
    // heap: they are new every frame.
    constexpr int kAloneFrom_bytes = 128 << 10;
    constexpr int kKeptOnTop_bytes = 24 << 20;  // of what a frame takes
    constexpr int kStep_bytes = 1 << 20;
    ::mallopt(M_ARENA_MAX, kArenas);
    ::mallopt(M_MMAP_THRESHOLD, kAloneFrom_bytes);
    ::mallopt(M_TRIM_THRESHOLD, kKeptOnTop_bytes);
    ::mallopt(M_TOP_PAD, kStep_bytes);
}

}  // namespace quadrat::kiosk
