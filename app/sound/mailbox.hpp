// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <atomic>
#include <cstddef>
#include <optional>
#include <utility>

namespace quadrat::sound {

// A bounded queue from one thread to one other. Neither ever waits.
template <typename Letter, std::size_t kRoom>
class Mailbox {
  public:
    // By the one thread. False: it is full, and the letter was not taken.
    bool post(Letter letter) {
        const std::size_t at = posted_.load(std::memory_order_relaxed);
        if (at - taken_.load(std::memory_order_acquire) == kRoom) return false;
        letters_[at % kRoom] = std::move(letter);
        posted_.store(at + 1, std::memory_order_release);
        return true;
    }
    // By the other. Nothing: it is empty.
    std::optional<Letter> take() {
        const std::size_t at = taken_.load(std::memory_order_relaxed);
        if (at == posted_.load(std::memory_order_acquire)) return std::nullopt;
        std::optional<Letter> letter(std::exchange(letters_[at % kRoom], Letter{}));
        taken_.store(at + 1, std::memory_order_release);
        return letter;
    }

  private:
    std::array<Letter, kRoom> letters_{};
    std::atomic<std::size_t> posted_{0}, taken_{0};
};

}  // namespace quadrat::sound
