// SPDX-License-Identifier: Apache-2.0
#include "sound/player.hpp"

#include <array>
#include <utility>

#include "base/log.hpp"

namespace quadrat::sound {
namespace {

constexpr std::chrono::milliseconds kBlockTime{10};
constexpr int kBlocksBetweenLooks = 200;  // two seconds

}  // namespace

Player::Player(OpenOutput open, const Soundscape& soundscape, const Levels& levels)
    : open_(std::move(open)), mixer_(soundscape, levels), thread_([this] { work(); }) {}

Player::~Player() {
    {
        const std::scoped_lock lock(mutex_);
        is_over_ = true;
    }
    over_.notify_all();
    thread_.join();
}

void Player::tell(Order order) {
    if (!orders_.post(std::move(order))) ++dropped_;
}

void Player::say(Says speech) {
    if (!speech_.post(std::move(speech))) ++dropped_;
}

PlayerHealth Player::health() const {
    const std::scoped_lock lock(mutex_);
    return {is_playing_, underruns_, dropped_, trouble_};
}

bool Player::wait_unless_over(std::chrono::milliseconds span) {
    std::unique_lock lock(mutex_);
    return !over_.wait_for(lock, span, [this] { return is_over_; });
}

void Player::take_orders() {
    while (const auto order = orders_.take()) mixer_.hear(*order);
    while (const auto speech = speech_.take()) mixer_.hear(*speech);
}

void Player::set_trouble(std::string trouble) {
    const std::scoped_lock lock(mutex_);
    trouble_ = std::move(trouble);
}

void Player::find_card() {
    if (blocks_without_++ % kBlocksBetweenLooks != 0) return;
    std::string trouble;
    output_ = open_(trouble);
    is_playing_ = output_ != nullptr;
    if (output_)
        base::log::info("sound: it plays");
    else if (trouble != told_)
        base::log::warn("sound: {}; it is tried again every two seconds", trouble);
    told_ = trouble;
    set_trouble(std::move(trouble));
}

void Player::play_block() {
    std::array<Frame, kBlock> block;
    mixer_.fill(block);
    if (!output_) return;
    const Output::Outcome outcome = output_->play(block);
    if (outcome == Output::Outcome::Late) ++underruns_;
    if (outcome != Output::Outcome::Gone) return;
    is_playing_ = false;
    base::log::warn("sound: {}; the show goes on without it", output_->trouble());
    set_trouble(output_->trouble());
    output_.reset();
    blocks_without_ = 1;  // not at once: who unplugs a card has it in hand
}

void Player::work() {
    for (;;) {
        if (!output_) find_card();
        take_orders();
        play_block();
        // A card sets the pace by itself.
        if (!wait_unless_over(output_ ? std::chrono::milliseconds{0} : kBlockTime)) return;
    }
}

}  // namespace quadrat::sound
