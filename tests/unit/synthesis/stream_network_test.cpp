// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/stream_network.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "synthesis/land/drainage.hpp"
#include "synthesis/land/field_methods.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;
using land::StreamNetwork;
using land::StreamOptions;

StreamNetwork network_of(std::uint64_t seed, const StreamOptions& options = {}) {
    return StreamNetwork(options, base::Seed{seed});
}

TEST(StreamNetwork, EveryStreamDrainsToTheOutletAndItsBedFalls) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const StreamNetwork network = network_of(seed);
        const auto nodes = network.nodes();
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            ASSERT_GE(nodes[i].down, 0);
            ASSERT_GT(nodes[i].bed, nodes[static_cast<std::size_t>(nodes[i].down)].bed) << seed << ' ' << i;
            std::size_t at = i;
            for (std::size_t step = 0; at != 0; ++step) {
                ASSERT_LT(step, nodes.size()) << "runs in a ring";
                at = static_cast<std::size_t>(nodes[at].down);
            }
        }
        for (const StreamNetwork::Node& node : nodes) ASSERT_EQ(node.at, glm::clamp(node.at, 0.0F, 1.0F)) << seed;
        EXPECT_EQ(nodes[0].bed, 0);
        EXPECT_EQ(nodes[0].at.y, 1);
    }
}

// The land is fitted to the streams: on a bed it has the bed's height, so that water on it runs down all the way.
TEST(StreamNetwork, TheGroundMeetsEveryBedAndNoValleyCutsIntoAnother) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const StreamNetwork network = network_of(seed);
        double largest = 0;
        int rises = 0;
        for (const StreamNetwork::Node& up : network.nodes().subspan(1)) {
            const StreamNetwork::Node& down = network.nodes()[static_cast<std::size_t>(up.down)];
            float before = network.ground(up.at).height;
            for (int i = 1; i <= 8; ++i) {
                const float t = static_cast<float>(i) / 8;
                const float height = network.ground(glm::mix(up.at, down.at, t)).height;
                rises += height > before + 3.0e-4F;
                largest = std::max(largest, std::abs(static_cast<double>(glm::mix(up.bed, down.bed, t) - height)));
                before = height;
            }
        }
        EXPECT_EQ(rises, 0) << "a river that runs up, in the land of seed " << seed;
        EXPECT_LT(largest, 0.004 * static_cast<double>(network.highest())) << "off its bed, seed " << seed;
    }
}

TEST(StreamNetwork, NoTwoStreamsCross) {
    const auto side = [](glm::vec2 a, glm::vec2 b, glm::vec2 p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    };
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const StreamNetwork network = network_of(seed, {.levels = 3});
        const auto nodes = network.nodes();
        int crossings = 0;
        for (std::size_t i = 1; i < nodes.size(); ++i)
            for (std::size_t k = i + 1; k < nodes.size(); ++k) {
                const auto [a, b] = std::pair{nodes[i], nodes[static_cast<std::size_t>(nodes[i].down)]};
                const auto [c, d] = std::pair{nodes[k], nodes[static_cast<std::size_t>(nodes[k].down)]};
                constexpr float kTouch = 1.0e-7F;
                crossings += side(a.at, b.at, c.at) * side(a.at, b.at, d.at) < -kTouch * kTouch &&
                             side(c.at, d.at, a.at) * side(c.at, d.at, b.at) < -kTouch * kTouch;
            }
        EXPECT_EQ(crossings, 0) << seed;
    }
}

TEST(StreamNetwork, DrainsTheLandAsCloselyAsIsAsked) {
    const StreamNetwork wide = network_of(3, {.levels = 1});
    const StreamNetwork close = network_of(3, {.levels = 5});
    float farthest_wide = 0;
    float farthest_close = 0;
    for (int i = 0; i < 60 * 60; ++i) {
        const glm::vec2 at{(static_cast<float>(i % 60) + 0.5F) / 60, (static_cast<float>(i / 60) + 0.5F) / 60};
        farthest_wide = std::max(farthest_wide, wide.ground(at).to_stream);
        farthest_close = std::max(farthest_close, close.ground(at).to_stream);
    }
    EXPECT_GT(close.nodes().size(), 5 * wide.nodes().size());
    EXPECT_LT(farthest_close, 0.05F);
    EXPECT_GT(farthest_wide, 2 * farthest_close);
}

// Its water, set free on the finished field, takes the way that was drawn first.
TEST(StreamNetwork, WaterOnTheFieldFollowsTheFirstRiver) {
    land::FieldRequest r;
    r.size = 257;
    r.seed = base::Seed{8};
    const land::FieldMethod& method = *land::field_method("streams");
    const mesh::Field field = land::make_field(method, r);
    const auto network = land::prepared(method, r).streams;
    const land::Drainage drainage = land::drain(field, -1.0e9F);
    float most = 0;
    glm::vec2 mouth{0};
    for (int x = 0; x < r.size; ++x) {
        const float drained = drainage.drained_cells[field.index(x, r.size - 1)];
        if (drained > most) mouth = {static_cast<float>(x) / static_cast<float>(r.size - 1), 1};
        most = std::max(most, drained);
    }
    EXPECT_LT(glm::distance(mouth, network->nodes()[0].at), 0.02F);
    EXPECT_GT(most, 0.35F * static_cast<float>(r.size * r.size)) << "the river drains the better part of the land";
}

}  // namespace
