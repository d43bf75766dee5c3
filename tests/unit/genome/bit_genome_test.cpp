// SPDX-License-Identifier: Apache-2.0
#include "genome/bit_genome.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/seed.hpp"

namespace quadrat::genome {
namespace {

BitGenome random_bits(base::Seed seed) {
    base::RandomStream chance(seed);
    BitGenome genome;
    for (const Aspect aspect : kAspects)
        for (std::size_t i = 0; i < bit_count(aspect, Genome::Classic); ++i)
            genome[aspect].push_back(static_cast<std::uint8_t>(chance.below(2)));
    return genome;
}

BitGenome filled(std::uint8_t bit) {
    BitGenome genome;
    for (const Aspect aspect : kAspects) genome[aspect].assign(bit_count(aspect, Genome::Classic), bit);
    return genome;
}

TEST(BitGenome, ComesBackFromItsValuesBitForBit) {
    for (std::uint64_t i = 0; i < 5000; ++i) {
        const BitGenome bits = random_bits(base::Seed{1}.child(i));
        ASSERT_EQ(encode(decode(bits, Genome::Classic), Genome::Classic), bits) << "genome " << i;
    }
}

TEST(BitGenome, GivesValuesThatComeBackExactly) {
    for (std::uint64_t i = 0; i < 5000; ++i) {
        const ParameterValues values = decode(random_bits(base::Seed{2}.child(i)), Genome::Classic);
        ASSERT_EQ(decode(encode(values, Genome::Classic), Genome::Classic), values) << "genome " << i;
    }
}

TEST(BitGenome, DecodesAllZeroesToTheLeastAndAllOnesToTheGreatestValues) {
    const ParameterValues least = decode(filled(0), Genome::Classic);
    const ParameterValues greatest = decode(filled(1), Genome::Classic);
    for (const Aspect aspect : kAspects)
        for (const ParameterId id : parameters_of(aspect, Genome::Classic)) {
            EXPECT_EQ(least[id], parameter(id).min) << parameter(id).name;
            EXPECT_EQ(greatest[id], parameter(id).max) << parameter(id).name;
        }
}

TEST(BitGenome, ReadsARunMostSignificantBitFirst) {
    BitGenome bits = filled(0);
    const ParameterId first = parameters_of(Aspect::Trees, Genome::Classic).front();
    const Parameter& p = parameter(first);
    bits[Aspect::Trees][0] = 1;
    const double top_bit = std::exp2(p.bits - 1);
    const double expected = p.min + (static_cast<double>(p.max) - p.min) * top_bit / (std::exp2(p.bits) - 1.0);
    EXPECT_FLOAT_EQ(decode(bits, Genome::Classic)[first], static_cast<float>(expected));
}

TEST(BitGenome, StaysInRangeAndOneAspectNeverMovesAnother) {
    for (std::uint64_t i = 0; i < 500; ++i) {
        const BitGenome bits = random_bits(base::Seed{3}.child(i));
        BitGenome other = random_bits(base::Seed{4}.child(i));
        const Aspect kept = kAspects[i % kAspects.size()];
        other[kept] = bits[kept];
        const ParameterValues values = decode(bits, Genome::Classic);
        const ParameterValues others = decode(other, Genome::Classic);
        for (const Parameter& p : parameter_table()) {
            EXPECT_GE(values[p.id], p.min);
            EXPECT_LE(values[p.id], p.max);
            if (p.aspect == kept) {
                EXPECT_EQ(values[p.id], others[p.id]) << p.name;
            }
        }
    }
}

TEST(BitGenome, EncodesToTheNearestStep) {
    base::RandomStream chance(base::Seed{5});
    for (int i = 0; i < 2000; ++i) {
        ParameterValues values;
        for (const Parameter& p : parameter_table()) values.set(p.id, chance.between(p.min, p.max));
        const ParameterValues nearest = decode(encode(values, Genome::Classic), Genome::Classic);
        for (const Parameter& p : parameter_table()) {
            if (p.genome != Genome::Classic) continue;
            const float half_step = (p.max - p.min) / static_cast<float>((1 << p.bits) - 1) / 2.0F;
            EXPECT_LE(std::abs(nearest[p.id] - values[p.id]), half_step * 1.0001F) << p.name;
        }
    }
}

TEST(Bits, AreWrittenAsTextAndReadBack) {
    const Bits bits{0, 1, 1, 0, 1};
    EXPECT_EQ(text_of(bits), "01101");
    EXPECT_EQ(bits_of("01101"), bits);
    EXPECT_EQ(bits_of(""), Bits{});
    EXPECT_FALSE(bits_of("012"));
    EXPECT_FALSE(bits_of("0 1"));
}

}  // namespace
}  // namespace quadrat::genome
