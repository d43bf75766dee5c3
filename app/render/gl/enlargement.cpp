// SPDX-License-Identifier: Apache-2.0
#include "render/gl/enlargement.hpp"

#include <algorithm>
#include <cassert>

namespace quadrat::render::gl {
namespace {

std::size_t index(int n) { return static_cast<std::size_t>(n); }

struct Place {
    int before = 0;
    std::uint16_t share = 0;  // of the one after that, of 256
};

Place place_of(int at, int from, int to) {
    constexpr std::int64_t kWhole = 256;
    const std::int64_t steps = std::max(to - 1, 1);
    const std::int64_t place = (at * (from - 1) * kWhole + steps / 2) / steps;
    const std::int64_t before = std::min<std::int64_t>(place / kWhole, from - 2);
    return {static_cast<int>(before), static_cast<std::uint16_t>(place - before * kWhole)};
}

// In 16 bits, so that narrow vectors hold many: a difference that is negative comes right again modulo 2^16.
std::uint8_t mixed(std::uint8_t a, std::uint8_t b, std::uint16_t share_of_b) {
    const auto difference = static_cast<std::uint16_t>(b - a);
    return static_cast<std::uint8_t>(static_cast<std::uint16_t>(a * 256U + difference * share_of_b + 128U) >> 8U);
}

}  // namespace

Enlargement::Enlargement(glm::ivec2 from, glm::ivec2 to)
    : from_(from), to_(to), before_(index(to.x)), after_(index(to.x)) {
    assert(from.x >= 2 && from.y >= 2 && to.x >= from.x && to.y >= from.y);
    for (int x = 0; x < to.x; ++x) {
        const Place place = place_of(x, from.x, to.x);
        columns_.push_back(place.before);
        shares_.insert(shares_.end(), sizeof(std::uint32_t), place.share);
    }
    for (WideRow& row : wide_) row.bytes.resize(shares_.size());
}

void Enlargement::begin(std::span<const std::uint32_t> picture) {
    assert(picture.size() >= index(from_.x) * index(from_.y));
    picture_ = picture;
    for (WideRow& row : wide_) row.of = -1;
}

const std::uint8_t* Enlargement::widened(int row) {
    WideRow& wide = wide_[index(row % 2)];
    std::uint8_t* __restrict out = wide.bytes.data();
    if (wide.of == row) return out;
    wide.of = row;
    const std::uint32_t* from = picture_.data() + index(row) * index(from_.x);
    const int* columns = columns_.data();
    std::uint32_t* before = before_.data();
    std::uint32_t* after = after_.data();
    const std::size_t pixels = columns_.size();
    for (std::size_t x = 0; x < pixels; ++x) {
        before[x] = from[columns[x]];
        after[x] = from[columns[x] + 1];
    }
    const auto* a = reinterpret_cast<const std::uint8_t*>(before);
    const auto* b = reinterpret_cast<const std::uint8_t*>(after);
    const std::uint16_t* shares = shares_.data();
    const std::size_t bytes = shares_.size();
    for (std::size_t i = 0; i < bytes; ++i) out[i] = mixed(a[i], b[i], shares[i]);
    return out;
}

void Enlargement::write(int row, std::span<std::uint32_t> to) {
    assert(row >= 0 && row < to_.y && to.size() >= index(to_.x));
    const Place place = place_of(row, from_.y, to_.y);
    const std::uint8_t* above = widened(place.before);
    const std::uint8_t* below = widened(place.before + 1);
    std::uint8_t* __restrict out = reinterpret_cast<std::uint8_t*>(to.data());
    const std::size_t bytes = shares_.size();
    for (std::size_t i = 0; i < bytes; ++i) out[i] = mixed(above[i], below[i], place.share);
}

}  // namespace quadrat::render::gl
