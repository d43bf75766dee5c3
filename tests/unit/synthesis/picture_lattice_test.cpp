// SPDX-License-Identifier: Apache-2.0
#include "synthesis/noise/picture_lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "synthesis/land/field_methods.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;
using noise::PictureLattice;

constexpr float kTurn = 2 * std::numbers::pi_v<float>;

mesh::Field waves(int columns, int rows) {
    mesh::Field f(columns, rows);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            f.at(x, y) = 0.5F + 0.25F * std::sin(kTurn * static_cast<float>(x) / static_cast<float>(columns)) +
                         0.25F * std::cos(kTurn * static_cast<float>(y) / static_cast<float>(rows));
    return f;
}

mesh::Field ramp(int side) {
    mesh::Field f(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) f.at(x, y) = static_cast<float>(x + 2 * y) / static_cast<float>(3 * side - 3);
    return f;
}

land::FieldRequest request_with(const std::vector<mesh::Field>& pictures, int size) {
    land::FieldRequest r;
    r.size = size;
    r.features = 1;
    r.seed = base::Seed{4};
    r.pictures = std::make_shared<const PictureLattice>(pictures);
    return r;
}

TEST(PictureLattice, OneOctaveIsThePictureItself) {
    const mesh::Field picture = waves(64, 64);
    const mesh::Field field = land::make_field(*land::field_method("perlin"), request_with({picture}, 65));
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) ASSERT_NEAR(field.at(x, y), 2 * picture.at(x, y) - 1, 1.0e-4F) << x << ' ' << y;
}

TEST(PictureLattice, LeavesAPictureThatRepeatsAsItIsAndBlendsOneThatDoesNot) {
    EXPECT_EQ(PictureLattice({waves(48, 32)}).blended(), 0);
    EXPECT_EQ(PictureLattice({waves(48, 32), ramp(40)}).blended(), 1);
}

// No step from one repeat to the next is larger than those that the picture has within.
TEST(PictureLattice, ShowsNoSeamWhereItRepeats) {
    const PictureLattice lattice({ramp(64)});
    const noise::Octaves one{.count = 1};
    const float step = 1.0F / 256;
    const auto at = [&](float x, float y) { return lattice.fbm(noise::Key(7U), x, y, step, one); };
    float within = 0;
    float over = 0;
    for (float v = 0.01F; v < 1; v += 0.03F) {
        for (float u = 0.1F; u < 0.9F; u += step) within = std::max(within, std::abs(at(u + step, v) - at(u, v)));
        for (float u = 1 - 4 * step; u < 1 + 4 * step; u += step) {
            over = std::max(over, std::abs(at(u + step, v) - at(u, v)));
            over = std::max(over, std::abs(at(v, u + step) - at(v, u)));
        }
    }
    EXPECT_LT(over, 1.5F * within);
    EXPECT_GT(within, 0);
}

TEST(PictureLattice, GivesEachOctaveItsOwnPictureAndTheLastToTheRest) {
    const mesh::Field grey(8, 8, 0.5F);
    const mesh::Field first = land::make_field(*land::field_method("fbm"), request_with({waves(64, 64), grey}, 65));
    land::FieldRequest one = request_with({waves(64, 64)}, 65);
    one.octaves = 1;
    const mesh::Field alone = land::make_field(*land::field_method("fbm"), one);
    // Nine octaves, eight of them flat: the first one's share of all amplitudes.
    const float share = 1.0F / (2.0F - std::exp2(-8.0F));
    for (std::size_t i = 0; i < alone.samples.size(); ++i)
        ASSERT_NEAR(first.samples[i], share * alone.samples[i], 1.0e-4F);
}

TEST(PictureLattice, IsTheSameInAWindowAndForEveryMix) {
    for (const char* name : {"perlin", "fbm", "ridged", "hybrid", "hetero", "warp"}) {
        land::FieldRequest r = request_with({ramp(50)}, 129);
        const mesh::Field whole = land::make_field(*land::field_method(name), r);
        r.window = {40, 20, 33, 50};
        const mesh::Field part = land::make_field(*land::field_method(name), r);
        for (int y = 0; y < 50; ++y)
            for (int x = 0; x < 33; ++x) ASSERT_EQ(part.at(x, y), whole.at(40 + x, 20 + y)) << name;
        for (const float h : whole.samples) ASSERT_TRUE(std::isfinite(h) && std::abs(h) < 8) << name;
    }
}

TEST(PictureLattice, MixesOctavesAsNoiseIsMixed) {
    // Value noise is its own lattice: what the kernel sums, mixed() sums.
    const noise::Key key(11U);
    for (const noise::Mix mix : {noise::Mix::Sum, noise::Mix::Ridged, noise::Mix::Hybrid, noise::Mix::Hetero}) {
        const noise::Octaves octaves{.count = 1, .gain = 0.6F, .mix = mix};
        for (float x = 0.1F; x < 9; x += 0.37F) {
            const float value = noise::gradient(noise::Key(key.value + 0x9E3779B9U), x, 1.7F);
            EXPECT_NEAR(noise::mixed({&value, 1}, octaves), noise::fbm(key, x, 1.7F, octaves), 1.0e-5F);
        }
    }
}

// However often a fine picture is repeated, it is never coarser than the samples can hold.
TEST(PictureLattice, TakesACoarserPictureWhereSamplesAreFar) {
    mesh::Field board(256, 256);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) board.at(x, y) = static_cast<float>((x + y) % 2);
    const PictureLattice lattice({board});
    for (float x = 0; x < 1; x += 0.013F)
        EXPECT_NEAR(lattice.fbm(noise::Key(1U), x, 0.3F, 1.0F / 64, {.count = 1}), 0, 0.02F);
}

TEST(PictureLattice, IsRefusedByMethodsWithoutNoise) {
    for (const char* name : {"diamond-square", "cell", "island", "streams"}) {
        try {
            land::make_field(*land::field_method(name), request_with({waves(8, 8)}, 33));
            ADD_FAILURE() << name;
        } catch (const base::InputError& error) {
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
        }
    }
}

}  // namespace
