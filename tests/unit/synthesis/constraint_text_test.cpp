// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/constraint_text.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;

template <typename Read>
std::string message_of(const Read& read) {
    try {
        read();
    } catch (const base::InputError& error) {
        return error.what();
    }
    return {};
}

TEST(ConstraintText, IsReadLineByLineWithRemarks) {
    const auto points = land::fixed_points_from("# the top\n\n 12\t7 -0.5  # here\r\n0 0 1e-2\n", "f");
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0].column, 12);
    EXPECT_EQ(points[0].row, 7);
    EXPECT_EQ(points[0].height, -0.5F);
    EXPECT_EQ(points[1].height, 0.01F);
    const auto lines = land::lines_from("ridge 0 0 1 5 5 2\nriver 9 9 1 3 3 0.5 1 1 0", "f");
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0].kind, land::Line::Kind::Ridge);
    EXPECT_EQ(lines[1].kind, land::Line::Kind::River);
    EXPECT_EQ(lines[1].corners.size(), 3U);
}

TEST(ConstraintText, RefusesWhatItCannotReadAndSaysWhere) {
    const auto fixed = [](std::string_view text) {
        return message_of([text] { land::fixed_points_from(text, "five.txt"); });
    };
    EXPECT_EQ(fixed("1 2 3\n1 x 3"), "five.txt:2: the row is x; a whole number of samples is right");
    EXPECT_EQ(fixed("1 2"), "five.txt:1: the height is missing");
    EXPECT_EQ(fixed("1 2 nan"), "five.txt:1: the height is nan; a number is right, as 0.75");
    EXPECT_EQ(fixed("1 2 3 4"), "five.txt:1: a fixed point is three numbers: column row height");
    EXPECT_EQ(fixed("99999999999 2 3"), "five.txt:1: the column is 99999999999; a whole number of samples is right");
    EXPECT_EQ(fixed("1 2 \x01\x80zzzzzzzzzzzzzzzzzzzzzzzzzzzzzz"),
              "five.txt:1: the height is ??zzzzzzzzzzzzzzzzzzzzzz...; a number is right, as 0.75");
    const auto lines = [](std::string_view text) { return message_of([text] { land::lines_from(text, "l.txt"); }); };
    EXPECT_EQ(lines("\ncrest 1 2 3 4 5 6"), "l.txt:2: a line begins with ridge or river");
    EXPECT_EQ(lines("ridge 1 2 3"), "l.txt:1: a line has two or more corners, three numbers each: column row height");
}

}  // namespace
