// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sys/types.h>

#include <mutex>
#include <vector>

namespace quadrat::kiosk {

// How a thread gives way to the one that draws: with a tenth of its weight, or whenever that wants to run at all.
enum class Way { Low, Idle };

// The calling thread, from now on.
void give_way(Way way);

// Threads that give way together, each from when it joins. Of any thread.
class LowPriority {
  public:
    void join();   // the calling thread
    void leave();  // before it ends
    void set(Way way);

  private:
    std::mutex mutex_;
    std::vector<pid_t> threads_;
    Way way_ = Way::Idle;
};

}  // namespace quadrat::kiosk
