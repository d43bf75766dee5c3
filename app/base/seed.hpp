// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

namespace quadrat::base {

// A name for a piece of randomness. Two seeds that differ anywhere give unrelated streams.
// Randomness is keyed by identity (scene, aspect, object, index), never by call order:
//     RandomStream twigs{seed.child("twigs").child(tree_index)};
struct Seed {
    std::uint64_t value = 0;

    Seed child(std::string_view name) const;
    Seed child(std::uint64_t index) const;
    friend bool operator==(Seed, Seed) = default;
};

// xoshiro256** (Blackman & Vigna 2018), seeded by splitmix64. Exact on every processor.
class RandomStream {
  public:
    explicit RandomStream(Seed seed);

    std::uint64_t bits();
    double unit();                             // in [0, 1), 53 bits
    float unit_f();                            // in [0, 1), 24 bits
    float between(float low, float high);      // in [low, high)
    std::uint32_t below(std::uint32_t count);  // in [0, count), unbiased; count 0 gives 0
    float normal();                            // mean 0, deviation 1; sum of twelve uniforms, so exact and within ±6

  private:
    std::array<std::uint64_t, 4> state_{};
};

// Stateless: a hash of integer coordinates, for noise and for random numbers tied to a point's identity.
std::uint64_t hash_of(Seed seed, std::int64_t x, std::int64_t y, std::int64_t z = 0);
float unit_of(std::uint64_t hash);  // in [0, 1)

// What is drawn a hundred thousand times for a scene, inline.

inline constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ULL;

// Steele, Lea & Flood 2014, as finalised by Vigna.
constexpr std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

inline std::uint64_t hash_of(Seed seed, std::int64_t x, std::int64_t y, std::int64_t z) {
    std::uint64_t h = seed.value;
    h = mix(h + kGolden * static_cast<std::uint64_t>(x));
    h = mix(h + kGolden * static_cast<std::uint64_t>(y));
    return mix(h + kGolden * static_cast<std::uint64_t>(z));
}

inline float unit_of(std::uint64_t hash) { return static_cast<float>(hash >> 40U) * 0x1.0p-24F; }

inline RandomStream::RandomStream(Seed seed) {
    std::uint64_t z = seed.value;
    for (auto& word : state_) word = mix(z += kGolden);
}

inline std::uint64_t RandomStream::bits() {
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

inline double RandomStream::unit() { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }
inline float RandomStream::unit_f() { return unit_of(bits()); }
inline float RandomStream::between(float low, float high) { return low + (high - low) * unit_f(); }

}  // namespace quadrat::base
