// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "kiosk/show.hpp"

namespace quadrat::kiosk {
namespace {

using learning::options_of_visit;

site::Configuration configured(const char* toml) { return site::configuration_from(toml, "site.toml"); }

TEST(ConfiguredShow, HasTheSitesTimes) {
    const exhibit::Timings timings = timings_of(configured("[visit]\nrounds = 3\npatience_s = 12.5\n"));
    EXPECT_EQ(timings.rounds, 3);
    EXPECT_EQ(timings.patience, std::chrono::milliseconds(12500));
}

TEST(ConfiguredShow, BreedsInWordsWithinTheSitesRanges) {
    const auto standard = breeder_options_of(site::Configuration{});
    EXPECT_EQ(standard.kind, breeding::BreederKind::Belief);
    EXPECT_EQ(standard.genome, genome::Genome::Full);
    const auto wet = breeder_options_of(configured("[words]\nwet = [-1, 0.25]\n"))
                         .ranges[static_cast<std::size_t>(genome::WordId::wet)];
    EXPECT_EQ(wet, (breeding::WordRange{-1, 0.25F}));
    const auto classic = breeder_options_of(configured("[breeding]\ngenome = \"classic\"\nbreeder = \"pbil\"\n"));
    EXPECT_EQ(classic.genome, genome::Genome::Classic);
    const auto random = breeder_options_of(configured("[breeding]\nmutation_form = \"random\"\n"));
    EXPECT_EQ(random.pbil.mutation_form, breeding::MutationForm::Random);
}

TEST(ConfiguredShow, HasChanceBreedOneVisitOfSoMany) {
    const auto belief = breeder_options_of(site::Configuration{});
    int by_chance = 0;
    for (std::uint64_t visit = 0; visit < 2000; ++visit) {
        const base::Seed seed = base::Seed{3}.child(visit);
        EXPECT_EQ(options_of_visit(belief, 0, seed).kind, breeding::BreederKind::Belief);
        EXPECT_EQ(options_of_visit(belief, 1, seed).kind, breeding::BreederKind::Chance);
        by_chance += options_of_visit(belief, 10, seed).kind == breeding::BreederKind::Chance;
    }
    EXPECT_NEAR(by_chance, 200, 45);
    const auto classic = breeder_options_of(configured("[breeding]\ngenome = \"classic\"\n"));
    EXPECT_EQ(options_of_visit(classic, 1, base::Seed{3}), classic) << "there it has no words to begin with";
}

}  // namespace
}  // namespace quadrat::kiosk
