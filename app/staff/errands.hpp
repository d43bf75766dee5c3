// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace quadrat::staff {

// What must not keep a frame waiting, on a thread of its own: files, mostly. One at a time, in order. While the disk
// hangs, what comes too much is refused.
class Errands {
  public:
    Errands() : thread_([this] { work(); }) {}
    ~Errands();  // finishes what was begun, drops the rest
    Errands(const Errands&) = delete;
    Errands& operator=(const Errands&) = delete;

    // False: too much is waiting, and this was dropped. The errand must not throw.
    bool send(std::function<void()> errand);

  private:
    void work();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<std::function<void()>> waiting_;
    bool is_ending_ = false;
    std::thread thread_;
};

}  // namespace quadrat::staff
