// SPDX-License-Identifier: Apache-2.0
#include "benches/visit_plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace quadrat::benches {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

TEST(VisitPlot, MarksEachDecisionWithItsReason) {
    std::vector<FrameSeen> frames;
    for (int i = 0; i < 120; ++i) frames.push_back({i * 16ms, 16ms, 16ms, 16ms});
    const std::string svg =
        plot_of(frames, {{1s, "detail 0.50, was 1.00: 3 of 32 frames late"}, {1500ms, "a < b & c"}});
    EXPECT_THAT(svg, HasSubstr("<title>1.0 s: detail 0.50, was 1.00: 3 of 32 frames late</title>"));
    EXPECT_THAT(svg, HasSubstr("<title>1.5 s: a &lt; b &amp; c</title>"));
    EXPECT_THAT(plot_of(frames, {}), testing::Not(HasSubstr("<title>")));
}

}  // namespace
}  // namespace quadrat::benches
