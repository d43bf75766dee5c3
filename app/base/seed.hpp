// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
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
    std::array<std::uint64_t, 4> state_;
};

// Stateless: a hash of integer coordinates, for noise and for random numbers tied to a point's identity.
std::uint64_t hash_of(Seed seed, std::int64_t x, std::int64_t y, std::int64_t z = 0);
float unit_of(std::uint64_t hash);  // in [0, 1)

}  // namespace quadrat::base
