// SPDX-License-Identifier: Apache-2.0
#include "kiosk/keeper.hpp"

#include "base/log.hpp"

namespace quadrat::kiosk {
namespace {
constexpr std::size_t kMostWaiting = 1000;
}

Keeper::Keeper(exhibit::Archive archive) : archive_(std::move(archive)), thread_([this] { work(); }) {}

Keeper::~Keeper() {
    {
        const std::scoped_lock lock(mutex_);
        is_ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

Keeper::Ticket Keeper::post(Work work) {
    const std::scoped_lock lock(mutex_);
    // A disk that hangs for hours must not fill the memory: what is lost then is lost with the disk.
    if (queue_.size() >= kMostWaiting) return posted_;
    queue_.push_back(std::move(work));
    changed_.notify_all();
    return ++posted_;
}

bool Keeper::is_done(Ticket ticket) {
    const std::scoped_lock lock(mutex_);
    return done_ >= ticket;
}

void Keeper::wait(Ticket ticket) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return done_ >= ticket; });
}

std::string Keeper::trouble() {
    const std::scoped_lock lock(mutex_);
    return last_trouble_;
}

std::chrono::milliseconds Keeper::waited_for() {
    const std::scoped_lock lock(mutex_);
    if (!is_working_) return std::chrono::milliseconds{0};
    return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begun_);
}

void Keeper::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return !queue_.empty() || is_ending_; });
        if (queue_.empty()) return;
        const Work next = std::move(queue_.front());
        queue_.pop_front();
        begun_ = std::chrono::steady_clock::now();
        is_working_ = true;
        lock.unlock();
        const exhibit::Trouble trouble = next(archive_);
        lock.lock();
        is_working_ = false;
        if (trouble && *trouble != last_trouble_) base::log::error("state: {}", *trouble);
        last_trouble_ = trouble.value_or("");
        ++done_;
        changed_.notify_all();
    }
}

}  // namespace quadrat::kiosk
