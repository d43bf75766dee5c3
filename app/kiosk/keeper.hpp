// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "exhibit/archive.hpp"

namespace quadrat::kiosk {

// The archive on a thread of its own: a commit waits for the disk, and a frame must not. Work is done in order; what
// could not be kept is logged, once for each kind of trouble.
class Keeper {
  public:
    using Work = std::function<exhibit::Trouble(exhibit::Archive&)>;
    using Ticket = std::uint64_t;

    explicit Keeper(exhibit::Archive archive);
    ~Keeper();  // does all that was asked for, then ends
    Keeper(const Keeper&) = delete;
    Keeper& operator=(const Keeper&) = delete;

    Ticket post(Work work);
    bool is_done(Ticket ticket);
    void wait(Ticket ticket);
    std::string trouble();  // of what was done last, "" if it was kept
    // How long the work at hand has been waiting for the disk; 0 while there is none.
    std::chrono::milliseconds waited_for();

  private:
    void work();

    exhibit::Archive archive_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Work> queue_;
    Ticket posted_ = 0;
    Ticket done_ = 0;
    bool is_ending_ = false;
    std::string last_trouble_;
    std::chrono::steady_clock::time_point begun_{};
    bool is_working_ = false;
    std::thread thread_;
};

}  // namespace quadrat::kiosk
