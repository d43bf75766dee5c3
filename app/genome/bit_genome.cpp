// SPDX-License-Identifier: Apache-2.0
#include "genome/bit_genome.hpp"

#include <cassert>
#include <cmath>

namespace quadrat::genome {
namespace {

std::uint32_t last_step(const Parameter& p) { return (1U << static_cast<unsigned>(p.bits)) - 1U; }

// In double, then rounded once: the float is the same whichever way the processor multiplies.
float value_at(const Parameter& p, std::uint32_t step) {
    const double range = static_cast<double>(p.max) - static_cast<double>(p.min);
    return static_cast<float>(static_cast<double>(p.min) + range * step / last_step(p));
}

std::uint32_t nearest_step(const Parameter& p, float value) {
    const double range = static_cast<double>(p.max) - static_cast<double>(p.min);
    const double share = (static_cast<double>(value) - static_cast<double>(p.min)) / range;
    return static_cast<std::uint32_t>(std::lround(share * last_step(p)));
}

}  // namespace

std::size_t bit_count(Aspect aspect, Genome genome) {
    std::size_t count = 0;
    for (const ParameterId id : parameters_of(aspect, genome)) count += static_cast<std::size_t>(parameter(id).bits);
    return count;
}

ParameterValues decode(const BitGenome& bits, Genome genome) {
    ParameterValues values;
    for (const Aspect aspect : kAspects) {
        assert(bits[aspect].size() == bit_count(aspect, genome));
        auto next_bit = bits[aspect].begin();
        for (const ParameterId id : parameters_of(aspect, genome)) {
            const Parameter& p = parameter(id);
            std::uint32_t step = 0;
            for (int i = 0; i < p.bits; ++i) step = step << 1U | *next_bit++;
            values.set(id, value_at(p, step));
        }
    }
    return values;
}

BitGenome encode(const ParameterValues& values, Genome genome) {
    BitGenome bits;
    for (const Aspect aspect : kAspects) {
        for (const ParameterId id : parameters_of(aspect, genome)) {
            const Parameter& p = parameter(id);
            const std::uint32_t step = nearest_step(p, values[id]);
            for (int i = p.bits - 1; i >= 0; --i)
                bits[aspect].push_back(static_cast<std::uint8_t>(step >> static_cast<unsigned>(i) & 1U));
        }
    }
    return bits;
}

std::string text_of(const Bits& bits) {
    std::string text;
    text.reserve(bits.size());
    for (const std::uint8_t bit : bits) text.push_back(bit != 0 ? '1' : '0');
    return text;
}

std::optional<Bits> bits_of(std::string_view text) {
    Bits bits;
    bits.reserve(text.size());
    for (const char c : text) {
        if (c != '0' && c != '1') return std::nullopt;
        bits.push_back(c == '1' ? 1 : 0);
    }
    return bits;
}

}  // namespace quadrat::genome
