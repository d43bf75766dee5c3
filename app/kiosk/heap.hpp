// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace quadrat::kiosk {

// For months, what growing frees must go back to the system: with an arena for each thread that grows, glibc's
// allocator holds on to ten times what is in use. What drivers take for a frame and free after it, some megabytes in
// small pieces, stays: given back, it would be cleared and mapped again page by page, every frame. Call once, before
// there are other threads.
void give_memory_back();

}  // namespace quadrat::kiosk
