// SPDX-License-Identifier: Apache-2.0
// What is kept while the show goes on: opened, read and written on a thread of its own.
#include "learning/keeper.hpp"

#include <gtest/gtest.h>

#include <future>

#include "support/process.hpp"

namespace quadrat::learning {
namespace {

using namespace std::chrono_literals;
using Urgency = Keeper::Urgency;

archive::WallTime noon() { return archive::WallTime{std::chrono::hours{12}}; }

archive::Archive opened(const std::filesystem::path& folder, const archive::TellKept& tell = {}) {
    return archive::Archive::open(folder, noon(), {}, tell).archive;
}

archive::Trouble nothing(archive::Archive&) { return std::nullopt; }

TEST(Keeper, WritesWhatCanWaitWithWhatCannot) {
    const tests::TemporaryFolder folder;
    {
        Keeper keeper(opened(folder.path()));
        const auto first =
            keeper.post([](archive::Archive& archive) { return archive.remember("a", "1"); }, Urgency::Soon);
        std::this_thread::sleep_for(50ms);
        EXPECT_FALSE(keeper.is_done(first)) << "it waits for company";
        const auto second =
            keeper.post([](archive::Archive& archive) { return archive.remember("b", "2"); }, Urgency::Flushed);
        keeper.wait(second);
        EXPECT_TRUE(keeper.is_done(first));
        keeper.post([](archive::Archive& archive) { return archive.remember("c", "3"); }, Urgency::Soon);
    }
    const archive::Archive archive = opened(folder.path());
    EXPECT_EQ(archive.remembered("a"), "1");
    EXPECT_EQ(archive.remembered("b"), "2");
    EXPECT_EQ(archive.remembered("c"), "3") << "an orderly end loses nothing";
}

TEST(Keeper, TellsWhatWasKeptBeforeTheDiskHasTakenAnything) {
    const tests::TemporaryFolder folder;
    ASSERT_EQ(opened(folder.path()).remember("buttons", "fine"), std::nullopt);
    std::promise<void> disk;
    Keeper keeper([&](const archive::TellKept& tell) {
        auto archive = opened(folder.path(), tell);
        disk.get_future().wait();
        return archive;
    });
    const auto kept = keeper.kept_within(60s);
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->buttons, "fine");
    const auto ticket = keeper.post(nothing, Urgency::Flushed);
    EXPECT_FALSE(keeper.is_done(ticket));
    std::this_thread::sleep_for(20ms);
    EXPECT_GT(keeper.waited_for(), 0ms);
    disk.set_value();
    keeper.wait(ticket);
}

}  // namespace
}  // namespace quadrat::learning
