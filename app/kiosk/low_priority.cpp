// SPDX-License-Identifier: Apache-2.0
#include "kiosk/low_priority.hpp"

#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace quadrat::kiosk {
namespace {

pid_t own_thread() { return static_cast<pid_t>(::syscall(SYS_gettid)); }

// A niceness can be given up, but not taken back; a policy can, so that alone changes.
void set_policy(pid_t thread, Way way) {
    const sched_param parameter{};
    ::sched_setscheduler(thread, way == Way::Idle ? SCHED_IDLE : SCHED_OTHER, &parameter);
}

}  // namespace

void give_way(Way way) {
    constexpr int kNice = 10;
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(own_thread()), kNice);
    set_policy(own_thread(), way);
}

void LowPriority::join() {
    const std::scoped_lock lock(mutex_);
    threads_.push_back(own_thread());
    give_way(way_);
}

void LowPriority::leave() {
    const std::scoped_lock lock(mutex_);
    std::erase(threads_, own_thread());
}

void LowPriority::set(Way way) {
    const std::scoped_lock lock(mutex_);
    if (way_ == way) return;
    way_ = way;
    for (const pid_t thread : threads_) set_policy(thread, way);
}

}  // namespace quadrat::kiosk
