// SPDX-License-Identifier: Apache-2.0
// A visit that was interrupted, on a disk that takes its time to tell of it.
#include <gtest/gtest.h>

#include <future>

#include "kiosk/show.hpp"
#include "support/process.hpp"

namespace quadrat::kiosk {
namespace {

using namespace std::chrono_literals;
using learning::Keeper;

archive::WallTime noon() { return archive::WallTime{std::chrono::hours{12}}; }

archive::Archive opened(const std::filesystem::path& folder, const archive::TellKept& tell = {}) {
    return archive::Archive::open(folder, noon(), {}, tell).archive;
}

// A visit of one press was interrupted; the disk tells so when it is told to.
class ShowOnASlowDisk : public testing::Test {
  protected:
    ShowOnASlowDisk() {
        configuration_.picture.land_samples = 65;
        Show before(configuration_, options(), opened(folder_.path()));
        before.open(1s);
        ready(before, 2s);
        before.happen(exhibit::Pressed{exhibit::Choice::A}, 5s);
    }
    ShowOptions options() const { return {base::Seed{4}, {1, {65, 64, 128}}, noon, noon, folder_.path()}; }
    static void ready(Show& show, base::Instant now) {
        show.finish_growing();
        if (show.programme().waiting_for_upload() != nullptr) show.uploaded(now);
    }
    std::unique_ptr<Show> slow_show() {
        auto keeper = std::make_unique<Keeper>([this](const archive::TellKept& tell) {
            disk_.get_future().wait();
            return opened(folder_.path(), tell);
        });
        keeper_ = keeper.get();
        return std::make_unique<Show>(configuration_, options(), std::move(keeper));
    }
    void disk_answers() {
        disk_.set_value();
        ASSERT_TRUE(keeper_->kept_within(60s));
    }

    tests::TemporaryFolder folder_;
    site::Configuration configuration_;
    std::promise<void> disk_;
    Keeper* keeper_ = nullptr;
};

TEST_F(ShowOnASlowDisk, BeginsWithoutItAndTakesUpTheVisitWhenItHasAnswered) {
    auto show = slow_show();
    show->open(1s);
    EXPECT_EQ(show->state().screen, exhibit::Screen::Attract);
    show->happen(exhibit::Tick{}, 2s);
    EXPECT_EQ(show->state().screen, exhibit::Screen::Attract);
    disk_answers();
    show->happen(exhibit::Tick{}, 3s);
    EXPECT_EQ(show->state().screen, exhibit::Screen::Breed);
    ready(*show, 4s);
    EXPECT_EQ(show->state().screen, exhibit::Screen::Ask);
}

TEST_F(ShowOnASlowDisk, LeavesTheVisitAloneWhenSomebodyElseHasCome) {
    auto show = slow_show();
    show->open(1s);
    show->happen(exhibit::Pressed{exhibit::Choice::A}, 2s);
    EXPECT_NE(show->state().screen, exhibit::Screen::Attract);
    disk_answers();
    const exhibit::State before = show->state();
    show->happen(exhibit::Tick{}, 3s);
    EXPECT_EQ(show->state().rounds, before.rounds);
    EXPECT_EQ(show->state().generation, before.generation);
}

TEST_F(ShowOnASlowDisk, GoesOnWithWhatItPreparedWhenTheVisitCannotBeTakenUp) {
    configuration_.breeding.breeder = "random";
    auto show = slow_show();
    show->open(1s);
    disk_answers();
    testing::internal::CaptureStderr();
    show->happen(exhibit::Tick{}, 2s);
    testing::internal::GetCapturedStderr();
    EXPECT_EQ(show->state().screen, exhibit::Screen::Attract);
    ready(*show, 3s);
    show->happen(exhibit::Pressed{exhibit::Choice::A}, 5s);
    EXPECT_EQ(show->state().screen, exhibit::Screen::Ask);
}

}  // namespace
}  // namespace quadrat::kiosk
