// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace quadrat::mesh {

// Edges by what their collapse costs, the cheapest quarter of an octave first. Costs so alike do not tell good from
// bad: within one, neighbours in memory come together, and of those whoever came first.
class CollapseQueue {
  public:
    struct Entry {
        std::uint32_t from, into;
        std::uint32_t version;  // whatever tells whether the two are still as they were
    };

    // Costs that are infinite or no number stay out.
    void push(const Entry& entry, float cost) {
        if (!(cost < std::numeric_limits<float>::max())) return;
        const std::size_t bucket = std::bit_cast<std::uint32_t>(cost) >> kShift;
        buckets_[bucket].push_back(entry);
        lowest_ = std::min(lowest_, bucket);
    }

    // False where none waits.
    bool pop(Entry& entry) {
        if (next_ == front_.size() && !refill()) return false;
        entry = front_[next_++];
        return true;
    }

    // One that will come so many later; null where that is not known.
    const Entry* ahead(std::size_t steps) const {
        return next_ + steps < front_.size() ? &front_[next_ + steps] : nullptr;
    }

    void clear() {
        for (auto& bucket : buckets_) bucket.clear();
        front_.clear();
        next_ = 0;
        lowest_ = kBuckets;
    }

  private:
    static constexpr int kShift = 21;  // of a float's 23 bits of fraction, two tell buckets apart
    static constexpr std::size_t kBuckets = 0x7F800000U >> kShift;
    static constexpr int kNear = 9;  // vertices that differ in these bits only are neighbours in memory

    bool refill() {
        while (lowest_ < kBuckets && buckets_[lowest_].empty()) ++lowest_;
        if (lowest_ == kBuckets) return false;
        const std::vector<Entry>& bucket = buckets_[lowest_];
        starts_.clear();
        for (const Entry& e : bucket) {
            const std::size_t at = (e.from >> kNear) + 1;
            if (at >= starts_.size()) starts_.resize(at + 1);
            ++starts_[at];
        }
        for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
        front_.resize(bucket.size());
        for (const Entry& e : bucket) front_[starts_[e.from >> kNear]++] = e;
        next_ = 0;
        buckets_[lowest_].clear();
        return true;
    }

    std::vector<std::vector<Entry>> buckets_ = std::vector<std::vector<Entry>>(kBuckets);
    std::vector<Entry> front_;  // of the cheapest bucket, neighbours together
    std::vector<std::uint32_t> starts_;
    std::size_t next_ = 0;
    std::size_t lowest_ = kBuckets;
};

}  // namespace quadrat::mesh
