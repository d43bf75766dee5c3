// SPDX-License-Identifier: Apache-2.0
#include "hearing/handset.hpp"

#include <utility>

namespace quadrat::hearing {

void Handset::press(exhibit::Instant now) {
    since_ = now;
    wishes_ = 0;
}

bool Handset::release(exhibit::Instant now) {
    const auto since = std::exchange(since_, std::nullopt);
    return since && wishes_ == 0 && now - *since < kRepeatAfter;
}

std::optional<exhibit::Instant> Handset::next_deadline() const {
    if (!since_) return std::nullopt;
    return *since_ + kRepeatAfter + wishes_ * kLouderEvery;
}

std::optional<Handset::Wish> Handset::look(exhibit::Instant now) {
    const auto due = next_deadline();
    if (!due || now < *due) return std::nullopt;
    return wishes_++ == 0 ? Wish::Repeat : Wish::Louder;
}

}  // namespace quadrat::hearing
