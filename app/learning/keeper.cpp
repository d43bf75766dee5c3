// SPDX-License-Identifier: Apache-2.0
#include "learning/keeper.hpp"

#include <utility>

#include "base/log.hpp"

namespace quadrat::learning {
namespace {
constexpr std::size_t kMostWaiting = 1000;
}

Keeper::Keeper(archive::Archive archive) : archive_(std::move(archive)), kept_(archive_->kept()) {}

Keeper::Keeper(Open open) {
    disk_.send([this, open = std::move(open)] {
        std::unique_lock lock(mutex_);
        wait_for_disk(lock, [&] { archive_ = open([this](const archive::Kept& kept) { tell(kept); }); });
    });
}

Keeper::~Keeper() {
    const std::scoped_lock lock(mutex_);
    is_ending_ = true;
}

std::optional<archive::Kept> Keeper::kept() {
    const std::scoped_lock lock(mutex_);
    return kept_;
}

std::optional<archive::Kept> Keeper::kept_within(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [this] { return kept_.has_value(); });
    return kept_;
}

// The first word counts: what is opened in its place, when it turns out to be of no use, holds nothing.
void Keeper::tell(const archive::Kept& kept) {
    const std::scoped_lock lock(mutex_);
    if (kept_) return;
    kept_ = kept;
    changed_.notify_all();
}

Keeper::Ticket Keeper::post(Work work, Urgency urgency) {
    const std::scoped_lock lock(mutex_);
    // A disk that hangs for hours must not fill the memory: what is lost then is lost with the disk.
    if (queue_.size() >= kMostWaiting) return posted_;
    queue_.push_back({std::move(work), urgency, std::chrono::steady_clock::now()});
    const bool is_asked = asked_.has_value();
    if (urgency == Urgency::Flushed) asked_ = archive::Durability::Flushed;
    if (urgency == Urgency::Written && !asked_) asked_ = archive::Durability::Written;
    if (asked_ && !is_asked) disk_.send([this] { write(); });
    arm();
    return ++posted_;
}

bool Keeper::is_done(Ticket ticket, std::chrono::nanoseconds patience) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, patience, [&] { return done_ >= ticket; });
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

void Keeper::wait_for_disk(std::unique_lock<std::mutex>& lock, const std::function<void()>& work) {
    begun_ = std::chrono::steady_clock::now();
    is_working_ = true;
    lock.unlock();
    work();
    lock.lock();
    is_working_ = false;
}

// With the lock: what is held is written in time, or at the end.
void Keeper::arm() {
    if (queue_.empty() || std::exchange(is_armed_, true)) return;
    disk_.send_at(queue_.front().at + kHold, [this] {
        {
            const std::scoped_lock lock(mutex_);
            is_armed_ = false;
        }
        write();
    });
}

void Keeper::write() {
    std::unique_lock lock(mutex_);
    const bool is_due =
        asked_ || is_ending_ || (!queue_.empty() && std::chrono::steady_clock::now() - queue_.front().at >= kHold);
    if (!is_due || queue_.empty()) return arm();
    std::deque<Posted> batch = std::exchange(queue_, {});
    const auto asked = std::exchange(asked_, std::nullopt);
    const auto durability = is_ending_ ? archive::Durability::Flushed : asked.value_or(archive::Durability::Written);
    const std::size_t count = batch.size();
    wait_for_disk(lock, [&] { do_together(std::move(batch), durability); });
    done_ += count;
    changed_.notify_all();
}

void Keeper::do_together(std::deque<Posted> batch, archive::Durability durability) {
    archive::Trouble last;
    const auto note = [&](const archive::Trouble& trouble) {
        const std::scoped_lock lock(mutex_);
        if (trouble && *trouble != last_trouble_) base::log::error("state: {}", *trouble);
        if (trouble) last_trouble_ = *trouble;
        if (trouble) last = trouble;
    };
    const archive::Trouble of_all = archive_->together(durability, [&] {
        for (const Posted& one : batch) note(one.work(*archive_));
    });
    note(of_all);
    const std::scoped_lock lock(mutex_);
    last_trouble_ = last.value_or("");
}

}  // namespace quadrat::learning
