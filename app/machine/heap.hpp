// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

#include "base/clock.hpp"

// How the allocator of the whole process behaves from now on. With an arena for each thread that grows, glibc's holds
// on to ten times what is in use: both leave it two, so the first call comes before there are other threads.
namespace quadrat::machine {

// For a start: what is freed is kept and taken again; nobody waits for the system to find pages and clear them.
void hold_memory();

// For months: what growing frees goes back to the system, and what is free now goes at once. What drivers take for a
// frame and free after it, some megabytes in small pieces, stays: it would be mapped and cleared again every frame.
// And tidies up, below.
void give_memory_back();

// What was freed in the midst of what is not goes back too, and the compilers are let go. From any thread; whoever
// allocates meanwhile waits, for 50 ms on a slow machine: a frame comes late.
void tidy_memory();

// When it may: after a visit, at most every ten minutes; and every hour where nobody comes.
class TimesToTidy {
  public:
    bool is_due(int visits_ended, base::Instant now);

  private:
    int visits_ended_ = 0;
    base::Instant last_{0};
};

// The code of a compiler that a software rasteriser brings, some fifty megabytes that are read while shaders are
// compiled and then lie in memory unused. Nothing is lost: should it be called again, the system finds it again, page
// by page, from its cache or the disk. Returns how many bytes of code were let go, resident or not; from any thread.
std::size_t let_go_of_compilers();

}  // namespace quadrat::machine
