// SPDX-License-Identifier: Apache-2.0
#include "staff/evidence.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "pictures/png_picture.hpp"
#include "staff/service_screen.hpp"
#include "support/process.hpp"

namespace quadrat::staff {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using testing::Contains;
using testing::HasSubstr;

const WallMoment kMoment = std::chrono::sys_days{std::chrono::year{2031} / 2 / 3} + 4h;

// Warnings of one run, as the log counts them.
class Warnings {
  public:
    base::RecentWarnings& warn(const std::string& text, WallMoment at = kMoment) {
        recent_.warnings.push_back({at, text});
        ++recent_.count;
        return recent_;
    }
    const base::RecentWarnings& recent() const { return recent_; }

  private:
    base::RecentWarnings recent_;
};

ino_t file_number(const tests::TemporaryFolder& state) {
    struct stat facts {};
    return ::stat((state / "faults/faults.json").c_str(), &facts) == 0 ? facts.st_ino : 0;
}

TEST(Evidence, TellsTheNextRunOfTheFaultsOfThisOne) {
    const tests::TemporaryFolder state;
    {
        Warnings run;
        Evidence evidence(state.path());
        evidence.look(run.warn("the projector is gone"), 1s);
        EXPECT_TRUE(evidence.earlier().empty()) << "they are of this run";
    }
    Evidence next(state.path());
    next.look({}, 1s);
    EXPECT_THAT(next.earlier(), testing::ElementsAre("2031-02-03 04:00:00 UTC the projector is gone"));
    Vitals vitals;
    vitals.earlier_faults = next.earlier();
    ServiceScreen screen;
    screen.open(0s);
    EXPECT_THAT(screen.board(vitals, 1s).lines, Contains(HasSubstr("the projector is gone")));
}

TEST(Evidence, WritesTheFirstFaultAtOnceAndMoreOnceAMinute) {
    const tests::TemporaryFolder state;
    Warnings run;
    Evidence evidence(state.path());
    evidence.look(run.warn("one"), 1s);
    EXPECT_EQ(read_faults(state.path()).size(), 1U) << "it may be the last thing that is done";
    evidence.look(run.warn("two"), 2s);
    evidence.look(run.recent(), 59s);
    EXPECT_EQ(read_faults(state.path()).size(), 1U);
    evidence.look(run.recent(), 62s);
    EXPECT_EQ(read_faults(state.path()).size(), 2U);
}

TEST(Evidence, OfAFaultThatComesAllDayIsOneLineAndAWriteAnHour) {
    const tests::TemporaryFolder state;
    Warnings run;
    Evidence evidence(state.path());
    int writes = 0;
    ino_t before = 0;
    for (int minute = 0; minute < 600; ++minute) {
        evidence.look(run.warn("button B is chattering", kMoment + std::chrono::minutes(minute)),
                      std::chrono::minutes(minute));
        if (std::exchange(before, file_number(state)) != before) ++writes;
    }
    EXPECT_LE(writes, 11);
    EXPECT_GE(writes, 9);
    const auto kept = read_faults(state.path());
    ASSERT_EQ(kept.size(), 1U);
    EXPECT_GT(kept[0].count, 500);
    EXPECT_EQ(kept[0].first, kMoment);
    EXPECT_THAT(to_line(kept[0]), HasSubstr("times, until 2031-02-03 1"));
}

TEST(Evidence, IsBoundedInNumberAndBytes) {
    const tests::TemporaryFolder state;
    Warnings run;
    Evidence evidence(state.path());
    for (int i = 0; i < 500; ++i)
        evidence.look(run.warn(std::to_string(i) + std::string(5000, '\xc3')), std::chrono::hours(i));
    const auto kept = read_faults(state.path());
    EXPECT_EQ(kept.size(), Evidence::kFaults);
    EXPECT_TRUE(kept.back().text.starts_with("499"));
    EXPECT_LT(fs::file_size(state / "faults/faults.json"), 64U << 10U);
}

TEST(Evidence, KeepsFewSmallPicturesAnHourApartAndTheNewestOfThem) {
    const tests::TemporaryFolder state;
    Warnings run;
    Evidence evidence(state.path());
    evidence.look(run.warn("the screen flickers"), 1s);
    const mesh::Image screen(3840, 2160, 4);
    const auto now = std::chrono::system_clock::now();
    evidence.keep_picture(screen, now);
    evidence.keep_picture(screen, now + 59min);
    EXPECT_FALSE(fs::exists(state / "faults/fault-2.png")) << "it is too soon";
    for (int i = 1; i < 10; ++i) evidence.keep_picture(screen, now + std::chrono::hours(2 * i));
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(state / "faults")) count += entry.path().extension() == ".png";
    EXPECT_EQ(count, Evidence::kPictures);
    EXPECT_FALSE(fs::exists(state / "faults/fault-6.png"));
    EXPECT_EQ(pictures::read_png_quickly(state / "faults/fault-10.png").width, 960);
    evidence.look(run.recent(), 2min);
    EXPECT_THAT(to_line(read_faults(state.path()).back()),
                HasSubstr("picture " + (state / "faults/fault-10.png").string()));
}

TEST(Evidence, ThatIsDamagedOrCannotBeKeptStopsNothing) {
    const tests::TemporaryFolder state;
    fs::create_directory(state / "faults");
    for (const char* text : {"", "{", "[]", R"({"faults":3})", R"({"faults":[{"text":1}]})"}) {
        state.write("faults/faults.json", text);
        EXPECT_TRUE(read_faults(state.path()).empty()) << text;
    }
    Warnings run;
    Evidence nowhere("/proc/version/state");
    nowhere.look(run.warn("no disk"), 1s);
    EXPECT_TRUE(nowhere.earlier().empty());
}

}  // namespace
}  // namespace quadrat::staff
