// SPDX-License-Identifier: Apache-2.0
#include "pictures/postcard.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quadrat::pictures {
namespace {

Postcard card_of(std::string title) {
    Postcard card;
    card.landscape = mesh::Image(kOnPostcard_px.x, kOnPostcard_px.y, 4);
    for (std::size_t i = 0; i < card.landscape.bytes.size(); ++i)
        card.landscape.bytes[i] = i % 4 == 1 ? 200 : i % 4 == 3 ? 255 : 0;
    card.title = std::move(title);
    card.below = "Museum · 2026-10-12";
    card.code = "Q2-" + std::string(330, 'A');
    return card;
}

bool has_ink(const mesh::Image& paper, int left, int top, int right, int bottom) {
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x)
            if (paper.pixel(x, y)[0] < 128) return true;
    return false;
}

// What may have no ink: the margin, and what lies between the landscape and what is under it.
bool is_within_margins(const mesh::Image& paper) {
    const int w = paper.width;
    const int h = paper.height;
    return !has_ink(paper, 0, 0, w, 50) && !has_ink(paper, 0, h - 50, w, h) && !has_ink(paper, 0, 0, 50, h) &&
           !has_ink(paper, w - 50, 0, w, h) && !has_ink(paper, 0, 770, w, 790);
}

TEST(APostcard, HasTheLandscapeItsWordsAndItsCodeWithinItsMargins) {
    for (const char* title :
         {"wet land; tall trees; a red sky", "one",
          "very rolling and very green land; very colourful and scattered trees; a very dark and "
          "cloudy sky over everything that anybody ever wished to see in a landscape of their own"}) {
        const mesh::Image paper = draw_postcard(card_of(title));
        ASSERT_EQ(paper.width, kPostcard_px.x);
        ASSERT_EQ(paper.height, kPostcard_px.y);
        EXPECT_TRUE(is_within_margins(paper)) << title;
        EXPECT_EQ(paper.pixel(paper.width / 2, 400)[1], 200);
        EXPECT_TRUE(has_ink(paper, 60, 796, 1200, 900)) << title;
        EXPECT_TRUE(has_ink(paper, 1500, 796, 1688, 1180)) << "its code";
        EXPECT_TRUE(has_ink(paper, 60, 1130, 600, 1190)) << "where and when";
    }
}

TEST(APostcard, IsMirroredWhereOneReadsFromTheRightAndMayHaveNoCode) {
    Postcard card = card_of("أرض خضراء؛ أشجار عالية؛ سماء حمراء");
    card.reads_right_to_left = true;
    card.below.clear();
    EXPECT_TRUE(has_ink(draw_postcard(card), 60, 1000, 400, 1180)) << "its code";
    card.code.clear();
    const mesh::Image paper = draw_postcard(card);
    EXPECT_FALSE(has_ink(paper, 60, 1000, 400, 1180));
    EXPECT_TRUE(is_within_margins(paper));
}

TEST(APostcard, LeavesOutACodeThatIsTooLongToBeReadFromPaper) {
    Postcard card = card_of("wet land");
    card.code = std::string(5000, 'A');
    card.below.clear();
    EXPECT_FALSE(has_ink(draw_postcard(card), 1400, 800, 1688, 1180));
}

}  // namespace
}  // namespace quadrat::pictures
