// SPDX-License-Identifier: Apache-2.0
#include "base/background_threads.hpp"

#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>

namespace quadrat::base {
namespace {

constexpr int kNice = 10;

pid_t this_thread() { return static_cast<pid_t>(::syscall(SYS_gettid)); }

// Leaving SCHED_IDLE is what raising the priority to the thread's nice value would be (sched(7)).
bool can_come_back() {
    rlimit limit{};
    const bool is_known = ::getrlimit(RLIMIT_NICE, &limit) == 0;
    return ::geteuid() == 0 || (is_known && limit.rlim_cur >= 20 - kNice);
}

}  // namespace

void BackgroundThreads::enter() {
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(this_thread()), kNice);
    const std::scoped_lock lock(mutex_);
    const pid_t thread = this_thread();
    if (std::ranges::find(threads_, thread) == threads_.end()) threads_.push_back(thread);
    apply(thread);
}

void BackgroundThreads::leave() {
    const std::scoped_lock lock(mutex_);
    std::erase(threads_, this_thread());
}

void BackgroundThreads::set_awaited(bool is_awaited) {
    const std::scoped_lock lock(mutex_);
    if (is_awaited_ == is_awaited) return;
    is_awaited_ = is_awaited;
    for (const pid_t thread : threads_) apply(thread);
}

void BackgroundThreads::apply(pid_t thread) const {
    static const bool may_idle = can_come_back();
    if (!may_idle) return;
    const sched_param none{};
    ::sched_setscheduler(thread, is_awaited_ ? SCHED_OTHER : SCHED_IDLE, &none);
}

}  // namespace quadrat::base
