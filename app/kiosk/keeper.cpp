// SPDX-License-Identifier: Apache-2.0
#include "kiosk/keeper.hpp"

#include <utility>

#include "base/log.hpp"

namespace quadrat::kiosk {
namespace {
constexpr std::size_t kMostWaiting = 1000;
}

Keeper::Keeper(archive::Archive archive) : archive_(std::move(archive)), kept_(archive_->kept()) {
    thread_ = std::thread([this] { work(); });
}

Keeper::Keeper(Open open) : open_(std::move(open)) {
    thread_ = std::thread([this] { work(); });
}

Keeper::~Keeper() {
    {
        const std::scoped_lock lock(mutex_);
        is_ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
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
    if (urgency == Urgency::Flushed) asked_ = archive::Durability::Flushed;
    if (urgency == Urgency::Written && !asked_) asked_ = archive::Durability::Written;
    changed_.notify_all();
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

void Keeper::work() {
    using std::chrono::steady_clock;
    std::unique_lock lock(mutex_);
    const auto waiting_for_the_disk = [&](const auto& task) {
        begun_ = steady_clock::now();
        is_working_ = true;
        lock.unlock();
        task();
        lock.lock();
        is_working_ = false;
    };
    if (!archive_)
        waiting_for_the_disk([this] { archive_ = open_([this](const archive::Kept& kept) { tell(kept); }); });
    const auto is_due = [this] {
        return asked_ || is_ending_ || (!queue_.empty() && steady_clock::now() - queue_.front().at >= kHold);
    };
    for (;;) {
        if (queue_.empty())
            changed_.wait(lock, [this] { return !queue_.empty() || is_ending_; });
        else
            changed_.wait_until(lock, queue_.front().at + kHold, is_due);
        if (queue_.empty() && is_ending_) return;
        if (!is_due()) continue;
        std::deque<Posted> batch = std::exchange(queue_, {});
        const auto asked = std::exchange(asked_, std::nullopt);
        const auto durability =
            is_ending_ ? archive::Durability::Flushed : asked.value_or(archive::Durability::Written);
        const std::size_t count = batch.size();
        waiting_for_the_disk([&] { do_together(std::move(batch), durability); });
        done_ += count;
        changed_.notify_all();
    }
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

}  // namespace quadrat::kiosk
