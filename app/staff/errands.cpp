// SPDX-License-Identifier: Apache-2.0
#include "staff/errands.hpp"

#include <utility>

namespace quadrat::staff {
namespace {
constexpr std::size_t kMostWaiting = 8;
}

Errands::~Errands() {
    {
        const std::scoped_lock lock(mutex_);
        is_ending_ = true;
        waiting_.clear();
    }
    changed_.notify_all();
    thread_.join();
}

bool Errands::send(std::function<void()> errand) {
    const std::scoped_lock lock(mutex_);
    if (waiting_.size() >= kMostWaiting) return false;
    waiting_.push_back(std::move(errand));
    changed_.notify_all();
    return true;
}

void Errands::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return !waiting_.empty() || is_ending_; });
        if (is_ending_) return;
        auto errands = std::exchange(waiting_, {});
        lock.unlock();
        for (const auto& errand : errands) errand();
        lock.lock();
    }
}

}  // namespace quadrat::staff
