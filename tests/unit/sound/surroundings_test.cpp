// SPDX-License-Identifier: Apache-2.0
#include "sound/surroundings.hpp"
#include "scene/parameters.hpp"
#include "synthesis/trees/form.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace quadrat::sound {
namespace {

// By day, dry, with leaves and no water: what follows changes one thing.
scene::SceneParameters plain() {
    scene::SceneParameters p;
    p.sky.night_share = -1;
    p.sky.sun_elevation_deg = 20;
    p.sky.sun_azimuth_deg = 40;
    p.sky.rain_share = p.sky.snowfall_share = 0;
    p.sky.cloud_wind_m_s = 6;
    p.land.ground_snow_line = 1;
    p.land.land_sea_level = p.land.island_share = 0;
    p.land.river_area_m2 = 500'000;
    p.land.marsh_share = 0;
    p.land.settle_chapel = 0;
    p.trees.tree_habit = 0;
    p.trees.tree_leaf_shape = 0;
    p.trees.tree_bareness = 0;
    p.trees.tree_leaf_density = 1;
    p.trees.tree_spacing_m = 5;
    return p;
}

float of(Voice voice, const scene::SceneParameters& parameters) { return surroundings_of(parameters)[voice]; }

TEST(Surroundings, FollowTheHour) {
    scene::SceneParameters night = plain(), morning = plain();
    night.sky.night_share = 1;
    morning.sky.sun_elevation_deg = 5;
    EXPECT_GT(of(Voice::Songbirds, morning), 2 * of(Voice::Songbirds, plain()));
    EXPECT_EQ(of(Voice::Songbirds, night), 0);
    EXPECT_EQ(of(Voice::Owls, plain()), 0);
    EXPECT_GT(of(Voice::Owls, night), 0.5F);
    EXPECT_GT(of(Voice::Crickets, night), 0.3F);
}

TEST(Surroundings, FollowTheWeather) {
    scene::SceneParameters rain = plain(), storm = plain();
    rain.sky.rain_share = 0.8F;
    rain.sky.cloud_tower = 2;
    storm.sky.cloud_wind_m_s = 25;
    EXPECT_GT(of(Voice::Rain, rain), 0.7F);
    EXPECT_GT(of(Voice::Thunder, rain), 0.3F);
    EXPECT_EQ(of(Voice::Songbirds, rain), 0) << "they hide";
    EXPECT_EQ(of(Voice::Rain, plain()) + of(Voice::Thunder, plain()), 0);
    EXPECT_GT(of(Voice::Wind, storm), 2 * of(Voice::Wind, plain()));
    EXPECT_GT(of(Voice::Leaves, storm), of(Voice::Leaves, plain()));
    EXPECT_LT(of(Voice::Songbirds, storm), of(Voice::Songbirds, plain()));
}

TEST(Surroundings, FollowWhatGrows) {
    scene::SceneParameters firs = plain(), bare = plain(), alone = plain();
    firs.trees.tree_habit = 2;
    bare.trees.tree_bareness = 1;
    alone.trees.tree_spacing_m = 25;
    EXPECT_EQ(of(Voice::Leaves, firs), 0);
    EXPECT_GT(of(Voice::Needles, firs), of(Voice::Needles, plain()));
    EXPECT_EQ(of(Voice::Leaves, bare), 0);
    EXPECT_LT(of(Voice::Leaves, alone), 0.5F * of(Voice::Leaves, plain()));
}

// The room may not ask which kinds bear needles: its lists have to say what the kinds' files say.
TEST(Surroundings, HearNeedlesOfTheKindsThatBearThem) {
    using synthesis::trees::LeafKind;
    for (int habit = 0; habit < synthesis::trees::kind_count(); ++habit)
        for (const LeafKind gene : {LeafKind::Ovate, LeafKind::Needles}) {
            const synthesis::trees::Kind& kind = synthesis::trees::kind(habit);
            scene::SceneParameters p = plain();
            p.trees.tree_habit = static_cast<float>(habit);
            p.trees.tree_leaf_shape = static_cast<float>(gene);
            EXPECT_EQ(of(Voice::Leaves, p) == 0, kind.own_leaf.value_or(gene) == LeafKind::Needles) << kind.name;
        }
}

TEST(Surroundings, FollowHowNearWaterIsAndWhetherPeopleLiveThere) {
    scene::SceneParameters sea = plain(), brook = plain(), village = plain();
    sea.land.land_sea_level = 0.5F;
    brook.land.river_area_m2 = 20'000;
    village.land.settle_chapel = 1;
    village.land.settle_age = 0.6F;
    EXPECT_EQ(of(Voice::Surf, plain()) + of(Voice::Stream, plain()) + of(Voice::Bells, plain()), 0);
    EXPECT_GT(of(Voice::Surf, sea), 0.25F);
    EXPECT_GT(of(Voice::Gulls, sea), 0.1F);
    EXPECT_GT(of(Voice::Stream, brook), 0.3F);
    EXPECT_GT(of(Voice::Bells, village), 0.3F);
}

TEST(Surroundings, AreTheMeanOfSeveralAndBetweenTwo) {
    Surroundings one, other;
    one.set(Voice::Rain, 1);
    other.set(Voice::Surf, 3);
    const std::vector<Surroundings> both{one, other};
    EXPECT_FLOAT_EQ(blend(both)[Voice::Rain], 0.5F);
    EXPECT_FLOAT_EQ(blend(both)[Voice::Surf], 0.5F) << "none is more than 1";
    EXPECT_EQ(blend({}), Surroundings{});
    EXPECT_FLOAT_EQ(between(one, other, 0.25F)[Voice::Rain], 0.75F);
    EXPECT_EQ(between(one, other, 7), other);
}

}  // namespace
}  // namespace quadrat::sound
