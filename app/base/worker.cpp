// SPDX-License-Identifier: Apache-2.0
#include "base/worker.hpp"

#include <pthread.h>

#include <optional>
#include <utility>

namespace quadrat::base {

Worker::~Worker() {
    {
        const std::scoped_lock lock(mutex_);
        is_ending_ = true;
    }
    if (options_.at_end == WorkerOptions::AtEnd::Drop) drop_waiting();
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

bool Worker::make_room(std::unique_lock<std::mutex>& lock) {
    using enum WorkerOptions::WhenFull;
    if (unfinished_ < options_.bound) return true;
    if (options_.when_full == Wait) {
        changed_.wait(lock, [this] { return unfinished_ < options_.bound; });
        return true;
    }
    if (options_.when_full == Refuse || waiting_.empty()) return false;
    waiting_.erase(waiting_.begin());
    --unfinished_;
    return true;
}

bool Worker::take(Due due, Sent sent) {
    std::unique_lock lock(mutex_);
    if (!make_room(lock)) return false;
    if (threads_.size() < options_.threads && threads_.size() <= unfinished_) threads_.emplace_back([this] { work(); });
    waiting_.emplace(due, std::move(sent));
    ++unfinished_;
    changed_.notify_all();
    return true;
}

void Worker::drop_waiting() {
    std::multimap<Due, Sent> dropped;  // what tasks hold is let go of without the lock
    const std::scoped_lock lock(mutex_);
    unfinished_ -= waiting_.size();
    dropped.swap(waiting_);
    changed_.notify_all();
}

void Worker::finish() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return unfinished_ == 0; });
}

// False: there will be none.
bool Worker::wait_for_task(std::unique_lock<std::mutex>& lock) {
    for (;;) {
        if (waiting_.empty()) {
            if (is_ending_) return false;
            changed_.wait(lock);
            continue;
        }
        const Due due = waiting_.begin()->first;
        if (due == Due{} || is_ending_) return true;
        if (changed_.wait_until(lock, due) == std::cv_status::timeout && !waiting_.empty() &&
            waiting_.begin()->first <= due)
            return true;
    }
}

void Worker::work() {
    ::pthread_setname_np(::pthread_self(), options_.name);
    std::optional<BackgroundThreads::Stay> stay;
    if (options_.priority == WorkerOptions::Priority::Background) stay.emplace(background_);
    std::unique_lock lock(mutex_);
    while (wait_for_task(lock)) {
        Sent sent = std::move(waiting_.extract(waiting_.begin()).mapped());
        lock.unlock();
        sent.task();
        sent.task = nullptr;  // what it holds goes before anybody hears that it is finished
        lock.lock();
        --unfinished_;
        changed_.notify_all();
        if (!sent.tell_end) continue;
        lock.unlock();
        sent.tell_end();
        lock.lock();
    }
}

}  // namespace quadrat::base
