// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "archive/archive.hpp"
#include "base/worker.hpp"

namespace quadrat::learning {

// The archive on a thread of its own: a commit waits for the disk, and a frame must not. Work is done in order, and
// what has gathered is written as one; what could not be kept is logged, once for each kind of trouble.
class Keeper {
  public:
    using Work = std::function<archive::Trouble(archive::Archive&)>;
    using Ticket = std::uint64_t;
    using Open = std::function<archive::Archive(const archive::TellKept& tell)>;

    enum class Urgency {
        Flushed,  // at once, with all before it; on the disk when it is done
        Written,  // at once, with all before it; with the system when it is done: a pulled plug may lose it
        Soon      // with what comes next, within kHold: a killed program loses it, and it is nothing that was on screen
    };
    static constexpr std::chrono::seconds kHold{15};

    explicit Keeper(archive::Archive archive);
    // Opens it on that thread: first reads what was kept, and tells; then writes, for as long as the disk takes.
    explicit Keeper(Open open);
    ~Keeper();  // does all that was asked for, then ends
    Keeper(const Keeper&) = delete;
    Keeper& operator=(const Keeper&) = delete;

    // What the last run left; nothing until that is known.
    std::optional<archive::Kept> kept();
    std::optional<archive::Kept> kept_within(std::chrono::milliseconds patience);

    Ticket post(Work work, Urgency urgency);
    bool is_done(Ticket ticket, std::chrono::nanoseconds patience = {});  // within it
    void wait(Ticket ticket);
    std::string trouble();  // of what was done last, "" if it was kept
    // How long the work at hand has been waiting for the disk; 0 while there is none.
    std::chrono::milliseconds waited_for();

  private:
    struct Posted {
        Work work;
        Urgency urgency;
        std::chrono::steady_clock::time_point at;
    };
    void tell(const archive::Kept& kept);
    void arm();
    void write();
    void wait_for_disk(std::unique_lock<std::mutex>& lock, const std::function<void()>& work);
    void do_together(std::deque<Posted> batch, archive::Durability durability);

    std::optional<archive::Archive> archive_;  // of the thread alone, once that runs
    std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<archive::Kept> kept_;
    std::deque<Posted> queue_;
    std::optional<archive::Durability> asked_;  // by what is urgent among them
    Ticket posted_ = 0;
    Ticket done_ = 0;
    bool is_ending_ = false;
    std::string last_trouble_;
    std::chrono::steady_clock::time_point begun_{};
    bool is_working_ = false;
    bool is_armed_ = false;                              // what is held will be written
    base::Worker disk_{{.name = "keeper", .bound = 4}};  // last: it ends before what it uses
};

}  // namespace quadrat::learning
