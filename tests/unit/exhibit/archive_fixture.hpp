// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <string>

#include "exhibit/archive.hpp"
#include "genome/recipe.hpp"

namespace quadrat::exhibit {

inline const WallTime kNow{std::chrono::sys_days{std::chrono::year{2031} / 2 / 3} + std::chrono::hours{4} +
                           std::chrono::minutes{5} + std::chrono::seconds{6}};

inline Generation generation_of(std::int64_t visit, int round) {
    Generation generation;
    generation.visit = visit;
    generation.seed = base::Seed{static_cast<std::uint64_t>(visit)};
    generation.flight = generation.seed.child("flight").child(static_cast<std::uint64_t>(round));
    generation.breeder = "pbil";
    generation.belief = fmt::format(R"({{"round":{}}})", round);
    generation.offer.round = round;
    for (std::size_t c = 0; c < genome::kCandidates; ++c) {
        const genome::Recipe recipe = genome::random_recipe(generation.flight.child(c));
        generation.offer.candidates[c] = {
            encode(recipe.values, genome::Genome::Classic), recipe.values, recipe.seeds, {}};
    }
    return generation;
}

class ArchiveOnDisk : public testing::Test {
  protected:
    void SetUp() override { use_directory_in(std::filesystem::temp_directory_path()); }
    void TearDown() override { std::filesystem::remove_all(directory_); }

    void use_directory_in(const std::filesystem::path& parent) {
        if (!directory_.empty()) std::filesystem::remove_all(directory_);
        std::string name = (parent / "quadrat-archive-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        directory_ = name;
    }

    Archive::Opened open(const Retention& retention = {}) const { return Archive::open(directory_, kNow, retention); }
    std::filesystem::path file() const { return directory_ / "quadrat.db"; }

    std::filesystem::path directory_;
};

}  // namespace quadrat::exhibit
