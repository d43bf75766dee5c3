// SPDX-License-Identifier: Apache-2.0
#include "base/seed.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace quadrat::base {
namespace {

TEST(Seed, GivesEveryChildANameOfItsOwn) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t parent = 0; parent < 50; ++parent) {
        const Seed seed{parent};
        for (std::uint64_t i = 0; i < 500; ++i) EXPECT_TRUE(seen.insert(seed.child(i).value).second);
        for (int i = 0; i < 500; ++i) EXPECT_TRUE(seen.insert(seed.child("object" + std::to_string(i)).value).second);
        EXPECT_TRUE(seen.insert(seed.child("").value).second);
    }
}

TEST(Seed, DependsOnTheWholePathToIt) {
    const Seed root{1};
    EXPECT_NE(root.child("trees").child(2), root.child(2).child("trees"));
    EXPECT_NE(root.child("ab").child("c"), root.child("a").child("bc"));
    EXPECT_EQ(root.child("trees").child(2), root.child("trees").child(2));
}

TEST(RandomStream, IsTheSameOnEveryMachine) {
    RandomStream stream(Seed{42});
    // xoshiro256** seeded by splitmix64(42), the generators' own published sequence.
    EXPECT_EQ(stream.bits(), 1546998764402558742ULL);
    EXPECT_EQ(stream.bits(), 6990951692964543102ULL);
    EXPECT_EQ(stream.bits(), 12544586762248559009ULL);
}

TEST(RandomStream, IsUniformInTheUnitInterval) {
    RandomStream stream(Seed{5});
    constexpr int kDraws = 200'000;
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < kDraws; ++i) {
        const double u = stream.unit();
        ASSERT_GE(u, 0.0);
        ASSERT_LT(u, 1.0);
        sum += u;
        squares += u * u;
    }
    EXPECT_NEAR(sum / kDraws, 1.0 / 2.0, 0.003);
    EXPECT_NEAR(squares / kDraws, 1.0 / 3.0, 0.003);
}

TEST(RandomStream, GivesEveryNumberBelowACountEquallyOften) {
    RandomStream stream(Seed{6});
    std::array<int, 7> counts{};
    for (int i = 0; i < 70'000; ++i) ++counts.at(stream.below(7));
    for (const int count : counts) EXPECT_NEAR(count, 10'000, 500);
    EXPECT_EQ(stream.below(0), 0U);
    EXPECT_EQ(stream.below(1), 0U);
}

TEST(RandomStream, HasUnrelatedStreamsForNeighbouringIndices) {
    // The first numbers of 10,000 sibling streams are themselves uniform and do not follow their neighbours.
    double sum = 0;
    double product = 0;
    double before = 0.5;
    constexpr int kStreams = 10'000;
    for (std::uint64_t i = 0; i < kStreams; ++i) {
        const double u = RandomStream(Seed{9}.child(i)).unit();
        sum += u;
        product += (u - 0.5) * (before - 0.5);
        before = u;
    }
    EXPECT_NEAR(sum / kStreams, 0.5, 0.012);
    EXPECT_NEAR(product / kStreams, 0.0, 0.004);
}

TEST(RandomStream, HasANormalOfMeanNoughtAndDeviationOne) {
    RandomStream stream(Seed{8});
    constexpr int kDraws = 100'000;
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < kDraws; ++i) {
        const double n = stream.normal();
        sum += n;
        squares += n * n;
    }
    EXPECT_NEAR(sum / kDraws, 0.0, 0.015);
    EXPECT_NEAR(squares / kDraws, 1.0, 0.02);
}

TEST(Hash, TellsPointsApartAndStaysInTheUnitInterval) {
    std::set<std::uint64_t> seen;
    for (std::int64_t x = -20; x < 20; ++x)
        for (std::int64_t y = -20; y < 20; ++y) {
            const std::uint64_t hash = hash_of(Seed{1}, x, y);
            EXPECT_TRUE(seen.insert(hash).second);
            EXPECT_GE(unit_of(hash), 0.0F);
            EXPECT_LT(unit_of(hash), 1.0F);
        }
    EXPECT_NE(hash_of(Seed{1}, 2, 3), hash_of(Seed{1}, 3, 2));
    EXPECT_NE(hash_of(Seed{1}, 2, 3), hash_of(Seed{2}, 2, 3));
    EXPECT_LT(unit_of(~std::uint64_t{0}), 1.0F);
}

}  // namespace
}  // namespace quadrat::base
