// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <epoxy/gl.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace quadrat::render::gl {

// Syncs of one context, in the order they were set. One that is done is deleted only when a later one is: llvmpipe
// looks at a fence's counter without its lock, so whoever polls and deletes may free the lock under the thread that is
// just leaving it. Who has signalled a later one has left all before it.
class Fences {
  public:
    Fences() = default;
    ~Fences();
    Fences(const Fences&) = delete;
    Fences& operator=(const Fences&) = delete;

    struct Sync {
        GLsync name = nullptr;
        std::uint64_t number = 0;
    };
    Sync set();
    // Done: it is not needed any more, and no earlier one.
    void passed(const Sync& sync);
    // Not needed, done or not.
    void given_up(const Sync& sync);

  private:
    std::uint64_t number_ = 0;
    std::vector<Sync> waiting_;  // to be deleted
};

// What was asked of the GPU until now.
class Fence {
  public:
    explicit Fence(std::shared_ptr<Fences> fences) : fences_(std::move(fences)) {}
    ~Fence() { forget(); }
    Fence(const Fence&) = delete;
    Fence& operator=(const Fence&) = delete;

    void set();
    // Waits for it so long at most; true when it is done, or none was set.
    bool is_done_within(std::chrono::nanoseconds patience);

  private:
    void forget();

    std::shared_ptr<Fences> fences_;
    Fences::Sync sync_;
};

}  // namespace quadrat::render::gl
