// SPDX-License-Identifier: Apache-2.0
#include "base/seed.hpp"

namespace quadrat::base {

Seed Seed::child(std::string_view name) const {
    std::uint64_t hash = 0xcbf29ce484222325ULL;  // FNV-1a: the name's identity, before mixing
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return Seed{mix(value + kGolden * (hash | 1U)) ^ mix(hash)};
}

Seed Seed::child(std::uint64_t index) const { return Seed{mix(mix(value + kGolden) + kGolden * (index + 1U))}; }

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

}  // namespace quadrat::base
