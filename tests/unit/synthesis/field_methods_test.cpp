// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/field_methods.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;
using land::FieldMethod;
using land::FieldRequest;

class EveryFieldMethod : public testing::TestWithParam<std::size_t> {
  protected:
    const FieldMethod& method() const { return land::field_methods()[GetParam()]; }
    static FieldRequest request(int size) {
        FieldRequest r;
        r.size = size;
        r.seed = base::Seed{91};
        return r;
    }
};

TEST_P(EveryFieldMethod, MakesAPatchAloneTheSameAsInTheWhole) {
    for (const int size : {129, 200}) {
        FieldRequest r = request(size);
        const mesh::Field whole = land::make_field(method(), r);
        for (const noise::Window w : {noise::Window{0, 0, 17, 9},
                                      {31, 62, 40, 33},
                                      {size - 1, 0, 1, size},
                                      {64, 64, 1, 1},
                                      {63, 65, 2, 2},
                                      {5, size - 7, 60, 7}}) {
            r.window = w;
            const mesh::Field patch = land::make_field(method(), r);
            ASSERT_EQ(patch.columns, w.columns);
            ASSERT_EQ(patch.rows, w.rows);
            for (int y = 0; y < w.rows; ++y)
                for (int x = 0; x < w.columns; ++x)
                    ASSERT_EQ(patch.at(x, y), whole.at(w.column + x, w.row + y))
                        << method().name << ' ' << x << ' ' << y;
        }
    }
}

TEST_P(EveryFieldMethod, MeetsItsFixedPointsExactlyInTheWholeAndInAPatch) {
    FieldRequest r = request(129);
    r.fixed = {{0, 0, -1},     {128, 0, -0.5F}, {0, 128, 0.25F}, {128, 128, 0},
               {64, 64, 2.5F}, {65, 64, 2.4F},  {17, 101, -2}};
    const mesh::Field whole = land::make_field(method(), r);
    for (const land::FixedPoint& p : r.fixed) EXPECT_EQ(whole.at(p.column, p.row), p.height) << method().name;
    r.window = {60, 50, 20, 30};
    const mesh::Field patch = land::make_field(method(), r);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 20; ++x) ASSERT_EQ(patch.at(x, y), whole.at(60 + x, 50 + y)) << method().name;
}

// Beside a fixed point the field goes on as its method has it, with no needle left standing.
TEST_P(EveryFieldMethod, StaysAsSmoothBesideAFixedPointAsElsewhere) {
    FieldRequest r = request(129);
    const mesh::Field plain = land::make_field(method(), r);
    r.fixed = {{40, 90, plain.at(40, 90) + 1.0F}};
    r.fixed.push_back({100, 20, plain.at(100, 20)});
    const mesh::Field bent = land::make_field(method(), r);
    const float moved = bent.at(40, 90) - plain.at(40, 90);
    const float beside = bent.at(41, 90) - plain.at(41, 90);
    EXPECT_NEAR(moved, 1, 1e-5);
    EXPECT_GT(beside, 0.97F);
}

TEST_P(EveryFieldMethod, IsFiniteAndOfOrdinarySize) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        FieldRequest r = request(129);
        r.seed = base::Seed{seed};
        for (const float h : land::make_field(method(), r).samples)
            ASSERT_TRUE(std::isfinite(h) && std::abs(h) < 8) << method().name;
    }
}

TEST_P(EveryFieldMethod, DiffersWithItsSeed) {
    FieldRequest r = request(65);
    const mesh::Field a = land::make_field(method(), r);
    r.seed = base::Seed{92};
    EXPECT_NE(a, land::make_field(method(), r)) << method().name;
}

INSTANTIATE_TEST_SUITE_P(All, EveryFieldMethod, testing::Range<std::size_t>(0, land::field_methods().size()),
                         [](const auto& which) {
                             std::string name(land::field_methods()[which.param].name);
                             for (char& c : name)
                                 if (c == '-') c = '_';
                             return name;
                         });

TEST(FieldMethods, AreFoundByName) {
    ASSERT_NE(land::field_method("diamond-square"), nullptr);
    EXPECT_EQ(land::field_method("diamond-square")->name, "diamond-square");
    EXPECT_EQ(land::field_method("marble"), nullptr);
}

TEST(FieldMethods, RefuseWhatIsOutOfRangeByName) {
    const FieldMethod& method = *land::field_method("fbm");
    const auto message = [&](const auto& change) -> std::string {
        FieldRequest r;
        r.size = 65;
        change(r);
        try {
            land::make_field(method, r);
        } catch (const base::InputError& error) {
            return error.what();
        }
        return {};
    };
    EXPECT_NE(message([](auto& r) { r.size = 8194; }).find("8194"), std::string::npos);
    EXPECT_NE(message([](auto& r) { r.size = 0; }).find("size"), std::string::npos);
    EXPECT_NE(message([](auto& r) { r.window = {60, 0, 6, 6}; }).find("window"), std::string::npos);
    EXPECT_NE(message([](auto& r) { r.window = {0, 0, 2147483647, 6}; }).find("window"), std::string::npos);
    EXPECT_NE(message([](auto& r) { r.octaves = 0; }).find("octaves"), std::string::npos);
    EXPECT_NE(message([](auto& r) { r.gain = std::numeric_limits<float>::quiet_NaN(); }).find("gain"),
              std::string::npos);
    EXPECT_NE(message([](auto& r) { r.fixed = {{65, 0, 1}}; }).find("65 0"), std::string::npos);
    EXPECT_NE(message([](auto& r) { r.fixed = {{3, 4, 1}, {3, 4, 2}}; }).find("twice"), std::string::npos);
    EXPECT_NE(message([](auto& r) { r.fixed = {{3, 4, std::nanf("")}}; }).find("not a number"), std::string::npos);
}

std::vector<land::Line> crest_and_bed() {
    return {{land::Line::Kind::Ridge, {{20, 30, 1.5F}, {120, 60, 1.2F}, {230, 40, 1.6F}}},
            {land::Line::Kind::River, {{30, 200, 0.1F}, {130, 150, -0.4F}, {240, 220, -0.9F}}}};
}

TEST_P(EveryFieldMethod, MeetsItsLinesAllAlongInTheWholeAndInAPatch) {
    FieldRequest r = request(257);
    r.lines = crest_and_bed();
    r.fixed = {{128, 10, 0.5F}, {126, 158, 0.2F}};
    const mesh::Field whole = land::make_field(method(), r);
    for (const land::Line& line : r.lines)
        for (const land::FixedPoint& p : land::points_along(line.corners, 1))
            EXPECT_EQ(whole.at(p.column, p.row), p.height) << method().name;
    for (const land::FixedPoint& p : r.fixed) EXPECT_EQ(whole.at(p.column, p.row), p.height) << method().name;
    r.window = {90, 120, 60, 50};
    const mesh::Field patch = land::make_field(method(), r);
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 60; ++x) ASSERT_EQ(patch.at(x, y), whole.at(90 + x, 120 + y)) << method().name;
}

// Two samples to each side nothing stands over a crest nor lies under a bed by more than one part in fifty.
TEST(Lines, AreCrestsAndBeds) {
    FieldRequest r;
    r.size = 257;
    r.seed = base::Seed{91};
    r.lines = crest_and_bed();
    const mesh::Field field = land::make_field(*land::field_method("fbm"), r);
    for (const land::Line& line : r.lines) {
        for (const land::FixedPoint& p : land::points_along(line.corners, 1)) {
            for (const int aside : {-2, 2}) {
                const float there = field.at(p.column, p.row + aside);
                if (line.kind == land::Line::Kind::Ridge)
                    EXPECT_LT(there, p.height + 0.02F) << p.column;
                else
                    EXPECT_GT(there, p.height - 0.02F) << p.column;
            }
        }
    }
}

// Beside a line the ground is as rough as anywhere: no smooth bank, no torn one.
TEST(Lines, LeaveTheGroundBesideThemAsRoughAsElsewhere) {
    FieldRequest r;
    r.size = 257;
    r.seed = base::Seed{91};
    const land::FieldMethod& method = *land::field_method("fbm");
    const mesh::Field plain = land::make_field(method, r);
    r.lines = crest_and_bed();
    const mesh::Field bent = land::make_field(method, r);
    const auto roughness = [&](const mesh::Field& field) {
        double sum = 0;
        for (const land::Line& line : r.lines)
            for (const land::FixedPoint& p : land::points_along(line.corners, 1))
                for (int y = p.row - 6; y <= p.row + 6; ++y)
                    sum += std::abs(field.at(p.column - 1, y) - 2 * field.at(p.column, y) + field.at(p.column + 1, y));
        return sum;
    };
    EXPECT_GT(roughness(bent), 0.6 * roughness(plain));
    EXPECT_LT(roughness(bent), 2.0 * roughness(plain));
}

TEST(Lines, RefuseWhatCannotBe) {
    const auto message = [](const auto& change) -> std::string {
        FieldRequest r;
        r.size = 65;
        change(r);
        try {
            land::check(r);
        } catch (const base::InputError& error) {
            return error.what();
        }
        return {};
    };
    using Kind = land::Line::Kind;
    EXPECT_NE(message([](auto& r) { r.lines = {{Kind::Ridge, {{1, 1, 0}}}}; }).find("two or more"), std::string::npos);
    EXPECT_NE(message([](auto& r) {
                  r.lines = {{Kind::Ridge, {{1, 1, 0}, {65, 1, 0}}}};
              }).find("65 1"),
              std::string::npos);
    EXPECT_NE(message([](auto& r) {
                  r.lines = {{Kind::River, {{1, 1, 0}, {9, 9, 0.5F}}}};
              }).find("rises"),
              std::string::npos);
    EXPECT_NE(message([](auto& r) {
                  r.lines = {{Kind::Ridge, {{0, 32, 1}, {64, 32, 1}}}, {Kind::River, {{32, 0, 0}, {32, 64, 0}}}};
              }).find("32 32"),
              std::string::npos);
}

TEST(PointsAlong, RunFromCornerToCornerWithoutGapsOrRepeats) {
    const std::vector<land::FixedPoint> line{{0, 0, 0}, {40, 10, 4}, {40, 50, 0}};
    const auto points = land::points_along(line, 8);
    ASSERT_GT(points.size(), 8U);
    EXPECT_EQ(points.front().column, 0);
    EXPECT_EQ(points.back().row, 50);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const int far =
            std::max(std::abs(points[i].column - points[i - 1].column), std::abs(points[i].row - points[i - 1].row));
        EXPECT_GE(far, 1);
        EXPECT_LE(far, 8);
    }
}

}  // namespace
