// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <string>

#include "archive/archive.hpp"
#include "genome/recipe.hpp"

namespace quadrat::archive {

inline const WallTime kNow{std::chrono::sys_days{std::chrono::year{2031} / 2 / 3} + std::chrono::hours{4} +
                           std::chrono::minutes{5} + std::chrono::seconds{6}};

inline Generation generation_of(std::int64_t visit, int round) {
    Generation generation;
    generation.visit = visit;
    generation.round = round;
    generation.seed = base::Seed{static_cast<std::uint64_t>(visit)}.child("session");
    generation.breeder = "pbil";
    for (int past = 1; past < round; ++past) {
        Deed deed;
        deed.pick[genome::Aspect::Trees] = static_cast<std::size_t>(past % 4);
        if (past % 3 == 0) deed.pick[genome::Aspect::Sky] = static_cast<std::size_t>(past % 2);
        generation.deeds.push_back(deed);
    }
    generation.digest = generation.seed.child(static_cast<std::uint64_t>(round)).value;
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

}  // namespace quadrat::archive
