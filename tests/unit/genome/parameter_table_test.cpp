// SPDX-License-Identifier: Apache-2.0
#include "genome/parameter_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "genome/bit_genome.hpp"
#include "genome/parameter_ids.hpp"

namespace quadrat::genome {
namespace {

std::vector<Parameter> classic_parameters() {
    std::vector<Parameter> classic;
    for (const Parameter& p : parameter_table())
        if (p.genome == Genome::Classic) classic.push_back(p);
    return classic;
}

TEST(ClassicGenome, Has21ParametersIn70BitsAsThePaperSays) {
    EXPECT_EQ(classic_parameters().size(), 21U);
    std::size_t bits = 0;
    for (const Aspect aspect : kAspects) bits += bit_count(aspect, Genome::Classic);
    EXPECT_EQ(bits, 70U);
}

TEST(ClassicGenome, HasNineLightingParametersAsThePaperSays) {
    int lighting = 0;
    for (const Parameter& p : classic_parameters())
        for (const std::string_view lead : {"sun.", "ambient.", "haze.", "sky."}) lighting += p.name.starts_with(lead);
    EXPECT_EQ(lighting, 9);
}

TEST(ParameterTable, NamesEveryParameterOnceAndFindsItByName) {
    std::set<std::string_view> names;
    for (const Parameter& p : parameter_table()) {
        EXPECT_TRUE(names.insert(p.name).second) << p.name << " stands twice";
        EXPECT_EQ(parameter_named(p.name), p.id);
        EXPECT_EQ(&parameter(p.id), &parameter_table()[static_cast<std::size_t>(p.id)]);
        EXPECT_EQ(parameter(p.id).name, p.name);
    }
    EXPECT_FALSE(parameter_named("tree.colour"));
    EXPECT_FALSE(parameter_named(""));
}

TEST(ParameterTable, HasARangeADefaultWithinItAndAMeaningInEveryRow) {
    for (const Parameter& p : parameter_table()) {
        SCOPED_TRACE(p.name);
        EXPECT_LT(p.min, p.max);
        EXPECT_GE(p.default_value, p.min);
        EXPECT_LE(p.default_value, p.max);
        EXPECT_GE(p.bits, 1);
        EXPECT_LE(p.bits, 8);
        EXPECT_FALSE(p.meaning.empty());
        if (p.name.ends_with("_deg")) {
            EXPECT_EQ(p.unit, "deg");
        }
        if (p.name.ends_with("_m")) {
            EXPECT_EQ(p.unit, "m");
        }
    }
}

TEST(ParameterTable, StandsInTheOrderOfTheQuestions) {
    std::vector<ParameterId> by_aspect;
    for (const Aspect aspect : kAspects)
        for (const ParameterId id : parameters_of(aspect, Genome::Full)) by_aspect.push_back(id);
    ASSERT_EQ(by_aspect.size(), kParameterCount);
    for (std::size_t i = 0; i < by_aspect.size(); ++i) EXPECT_EQ(by_aspect[i], static_cast<ParameterId>(i));
}

TEST(ParameterValues, StayInTheirRangeWhateverIsSet) {
    const float infinity = std::numeric_limits<float>::infinity();
    for (const Parameter& p : parameter_table()) {
        ParameterValues values;
        EXPECT_EQ(values[p.id], p.default_value);
        for (const float value : {-infinity, p.min - 1.0F, infinity, p.max + 1.0F, 0.0F}) {
            values.set(p.id, value);
            EXPECT_GE(values[p.id], p.min);
            EXPECT_LE(values[p.id], p.max);
        }
        values.set(p.id, std::nanf(""));
        EXPECT_EQ(values[p.id], p.default_value);
    }
}

TEST(Aspect, HasANameThatFindsIt) {
    for (const Aspect aspect : kAspects) EXPECT_EQ(aspect_named(name_of(aspect)), aspect);
    EXPECT_EQ(name_of(Aspect::Trees), "trees");
    EXPECT_EQ(name_of(Aspect::Land), "land");
    EXPECT_EQ(name_of(Aspect::Sky), "sky");
    EXPECT_FALSE(aspect_named("Trees"));
}

}  // namespace
}  // namespace quadrat::genome
