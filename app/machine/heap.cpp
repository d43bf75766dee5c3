// SPDX-License-Identifier: Apache-2.0
#include "machine/heap.hpp"

#include <link.h>
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <span>
#include <string_view>

namespace quadrat::machine {
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
    tidy_memory();
}

void tidy_memory() {
    ::malloc_trim(0);
    let_go_of_compilers();
}

bool TimesToTidy::is_due(int visits_ended, base::Instant now) {
    constexpr std::chrono::minutes kBetween{10};
    constexpr std::chrono::hours kNobodyCame{1};
    if (now - last_ < kBetween || (visits_ended == visits_ended_ && now - last_ < kNobodyCame)) return false;
    visits_ended_ = visits_ended;
    last_ = now;
    return true;
}

std::size_t let_go_of_compilers() {
    std::size_t bytes = 0;
    ::dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* sum) {
            if (std::string_view(info->dlpi_name).find("libLLVM") == std::string_view::npos) return 0;
            for (const ElfW(Phdr) & segment : std::span(info->dlpi_phdr, info->dlpi_phnum)) {
                // Code alone: what is written to, relocations among it, would come back as it lies on the disk.
                if (segment.p_type != PT_LOAD || (segment.p_flags & (PF_X | PF_W)) != PF_X) continue;
                const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
                const std::uintptr_t begin = info->dlpi_addr + segment.p_vaddr;
                const std::uintptr_t first = (begin + page - 1) / page * page;
                const std::uintptr_t end = (begin + segment.p_memsz) / page * page;
                if (end <= first || ::madvise(reinterpret_cast<void*>(first), end - first, MADV_DONTNEED) != 0)
                    continue;
                *static_cast<std::size_t*>(sum) += end - first;
            }
            return 0;
        },
        &bytes);
    return bytes;
}

}  // namespace quadrat::machine
