// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "sound/mailbox.hpp"
#include "sound/mixer.hpp"
#include "sound/output.hpp"

namespace quadrat::sound {

struct PlayerHealth {
    bool is_playing = false;
    std::uint64_t underruns = 0;  // gaps, since it began
    std::uint64_t dropped = 0;    // orders that came faster than they were taken
    std::string trouble;          // why it does not play, or ""
};

// Plays what it is told on a thread of its own, which alone waits for the card. Where there is none it looks for one
// every so often; what is said meanwhile passes unheard, in its time.
class Player {
  public:
    // Opens on its own thread. The soundscape is borrowed.
    Player(OpenOutput open, const Soundscape& soundscape, const Levels& levels);
    ~Player();
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    // By one thread: never waits. What does not find room is dropped and counted.
    void tell(Order order);
    // The same by one other thread, for speech.
    void say(Says speech);
    PlayerHealth health() const;

    static constexpr std::size_t kBlock = 480;  // frames that are mixed at a time: a hundredth of a second

  private:
    void work();
    void take_orders();
    void play_block();
    void find_card();
    void set_trouble(std::string trouble);
    bool wait_unless_over(std::chrono::milliseconds span);

    OpenOutput open_;
    Mixer mixer_;  // of the thread alone
    std::unique_ptr<Output> output_;
    int blocks_without_ = 0;
    std::string told_;  // in the log, last
    Mailbox<Order, 64> orders_;
    Mailbox<Says, 16> speech_;
    std::atomic<bool> is_playing_{false};
    std::atomic<std::uint64_t> underruns_{0}, dropped_{0};
    mutable std::mutex mutex_;  // of what is below; held for an assignment
    std::condition_variable over_;
    bool is_over_ = false;
    std::string trouble_;
    std::thread thread_;  // last: it ends before what it uses
};

}  // namespace quadrat::sound
