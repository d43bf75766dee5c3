// SPDX-License-Identifier: Apache-2.0
#include "kiosk/heap.hpp"

#include <malloc.h>

namespace quadrat::kiosk {
namespace {

struct Habits {
    int alone_from_bytes;   // its own mapping, gone when it is freed
    int kept_on_top_bytes;  // of the heap
};

void take_up(const Habits& habits) {
    constexpr int kArenas = 2;
    constexpr int kStep_bytes = 1 << 20;
    ::mallopt(M_ARENA_MAX, kArenas);
    ::mallopt(M_MMAP_THRESHOLD, habits.alone_from_bytes);
    ::mallopt(M_TRIM_THRESHOLD, habits.kept_on_top_bytes);
    ::mallopt(M_TOP_PAD, kStep_bytes);
}

}  // namespace

void hold_memory() { take_up({32 << 20, 512 << 20}); }

void give_memory_back() {
    // Pictures, lands are mappings. A software rasteriser's blocks of 64 KB stay in the heap: they are new every frame.
    take_up({128 << 10, 24 << 20});
    ::malloc_trim(0);
}

}  // namespace quadrat::kiosk
