// SPDX-License-Identifier: Apache-2.0
#include "base/seed.hpp"

#include <bit>

namespace quadrat::base {
namespace {

// Steele, Lea & Flood 2014, as finalised by Vigna.
std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ULL;

}  // namespace

Seed Seed::child(std::string_view name) const {
    std::uint64_t hash = 0xcbf29ce484222325ULL;  // FNV-1a: the name's identity, before mixing
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return Seed{mix(value + kGolden * (hash | 1U)) ^ mix(hash)};
}

Seed Seed::child(std::uint64_t index) const { return Seed{mix(mix(value + kGolden) + kGolden * (index + 1U))}; }

RandomStream::RandomStream(Seed seed) : state_{} {
    std::uint64_t z = seed.value;
    for (auto& word : state_) word = mix(z += kGolden);
}

std::uint64_t RandomStream::bits() {
    const std::uint64_t result = std::rotl(state_[1] * 5U, 7) * 9U;
    const std::uint64_t t = state_[1] << 17U;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = std::rotl(state_[3], 45);
    return result;
}

double RandomStream::unit() { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }
float RandomStream::unit_f() { return unit_of(bits()); }
float RandomStream::between(float low, float high) { return low + (high - low) * unit_f(); }

std::uint32_t RandomStream::below(std::uint32_t count) {
    if (count == 0) return 0;
    const std::uint32_t threshold = (0U - count) % count;  // Lemire 2019: reject the biased few
    for (;;) {
        const std::uint64_t product = (bits() >> 32U) * count;
        if (static_cast<std::uint32_t>(product) >= threshold) return static_cast<std::uint32_t>(product >> 32U);
    }
}

float RandomStream::normal() {
    float sum = -6.0F;
    for (int i = 0; i < 12; ++i) sum += unit_f();
    return sum;
}

std::uint64_t hash_of(Seed seed, std::int64_t x, std::int64_t y, std::int64_t z) {
    std::uint64_t h = seed.value;
    h = mix(h + kGolden * static_cast<std::uint64_t>(x));
    h = mix(h + kGolden * static_cast<std::uint64_t>(y));
    return mix(h + kGolden * static_cast<std::uint64_t>(z));
}

float unit_of(std::uint64_t hash) { return static_cast<float>(hash >> 40U) * 0x1.0p-24F; }

}  // namespace quadrat::base
