// SPDX-License-Identifier: Apache-2.0
#include "site/wall_clock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "support/process.hpp"

namespace quadrat::site {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr std::time_t kNow = 1'795'694'400;  // 2026-11-26 12:00:00 UTC
constexpr std::time_t kDay = 86'400;

// A machine with the real-time clocks that a test gives it.
class RealTimeClock : public testing::Test {
  protected:
    void has(const std::string& name, const std::string& since_epoch) const {
        std::filesystem::create_directories(sys / ("class/rtc/" + name));
        sys.write("class/rtc/" + name + "/since_epoch", since_epoch);
        sys.write("class/rtc/" + name + "/hctosys", "1\n");
    }
    WallClock judged(std::optional<std::time_t> last_seen = {}) const {
        return judge_clock(kNow, false, last_seen, sys.path());
    }
    tests::TemporaryFolder sys;
};

TEST_F(RealTimeClock, ThatAgreesWithinAMinuteMakesTheTimeTrusted) {
    has("rtc0", std::to_string(kNow - 60) + "\n");
    EXPECT_EQ(judged().source, "rtc0");
    has("rtc0", std::to_string(kNow + 61) + "\n");
    EXPECT_FALSE(judged().is_trusted);
    EXPECT_THAT(judged().doubt, HasSubstr("rtc0 shows 2026-11-26 12:01:01 UTC"));
}

TEST_F(RealTimeClock, ThatLostItsTimeVouchesForNothingThoughTheKernelOnceTookItsTime) {
    has("rtc0", "41\n");
    EXPECT_FALSE(judged().is_trusted);
    EXPECT_THAT(judged().doubt, HasSubstr("rtc0 shows 1970-01-01 00:00:41 UTC"));
    EXPECT_THAT(judged().remedy, HasSubstr("battery"));
}

TEST_F(RealTimeClock, IsEnoughWhereOneOfSeveralAgrees) {
    has("rtc0", "41\n");
    has("rtc1", std::to_string(kNow) + "\n");
    EXPECT_EQ(judged().source, "rtc1");
}

TEST_F(RealTimeClock, ThatCannotBeReadOrSaysNoNumberVouchesForNothing) {
    for (const char* wrong : {"", "\n", "now\n", "1795694400s\n", "99999999999999999999\n", "-9223372036854775808\n"}) {
        has("rtc0", wrong);
        EXPECT_FALSE(judged().is_trusted) << wrong;
    }
}

TEST_F(RealTimeClock, VouchesForNothingBeforeTheLastTimeSeen) {
    has("rtc0", std::to_string(kNow) + "\n");
    EXPECT_TRUE(judged(kNow - kDay).is_trusted);
    EXPECT_TRUE(judged(kNow + 59).is_trusted) << "a slow clock is no lost one";
    EXPECT_FALSE(judged(kNow + kDay).is_trusted);
    EXPECT_THAT(judged(kNow + kDay).doubt, HasSubstr("before the last time seen, 2026-11-27 12:00:00 UTC"));
    EXPECT_THAT(judged(kNow + kDay).remedy, HasSubstr("clock.seen"));
}

TEST_F(RealTimeClock, IsNotAskedWhereTheKernelIsSynchronised) {
    has("rtc0", "41\n");
    EXPECT_EQ(judge_clock(kNow, true, kNow + kDay, sys.path()).source, "synchronised");
    EXPECT_FALSE(judge_clock(41, true, {}, sys.path()).is_trusted) << "no network tells a year before this program's";
    EXPECT_FALSE(judge_clock(kNow + 80 * 365 * kDay, true, {}, sys.path()).is_trusted);
    EXPECT_THAT(judge_clock(kNow, false, {}, "/nowhere").doubt, HasSubstr("there is no real-time clock"));
}

TEST(LastTimeSeen, IsKeptAndGoesBackOnlyWhereAClockThatIsTrustedDoes) {
    const tests::TemporaryFolder state;
    LastTimeSeen seen(state.path());
    EXPECT_EQ(seen.read(), std::nullopt);
    seen.note(kNow);
    EXPECT_EQ(LastTimeSeen(state.path()).read(), kNow);
    seen.note(kNow + 60);
    EXPECT_EQ(seen.read(), kNow) << "once an hour is enough for the disk";
    EXPECT_THAT(tests::contents_of(state / "clock.seen"), HasSubstr("2026-11-26 12:00:00 UTC"));
    LastTimeSeen(state.path()).note(kNow - kDay);
    EXPECT_EQ(seen.read(), kNow - kDay);
    state.write("clock.seen", "broken\n");
    EXPECT_EQ(seen.read(), std::nullopt);
    EXPECT_EQ(LastTimeSeen("").read(), std::nullopt);
}

// Sets TZ for one test alone.
class TimeZone : public testing::Test {
  protected:
    TimeZone() {
        if (const char* tz = std::getenv("TZ")) before_ = tz;
    }
    ~TimeZone() override {
        if (before_)
            ::setenv("TZ", before_->c_str(), 1);
        else
            ::unsetenv("TZ");
        ::tzset();
    }
    static std::string zone_now() { return judge_clock(kNow, true, {}, "/nowhere").zone; }
    tests::TemporaryFolder folder;

  private:
    std::optional<std::string> before_;
};

TEST_F(TimeZone, IsReadAgainWhenTheFileThatTzNamesChanges) {
    const auto becomes = [&](const char* zone) {
        std::filesystem::remove(folder / "here");
        std::filesystem::create_symlink(std::string("/usr/share/zoneinfo/") + zone, folder / "here");
    };
    becomes("Europe/Berlin");
    ::setenv("TZ", (":" + (folder / "here").string()).c_str(), 1);
    ZoneWatch watch;
    EXPECT_EQ(zone_now(), "Europe/Berlin (CET, UTC+01:00)");
    for (const auto& [zone, text] : {std::pair{"Asia/Tokyo", "JST, UTC+09:00"},
                                     {"America/New_York", "EST, UTC-05:00"},
                                     {"Asia/Kathmandu", "+0545, UTC+05:45"}}) {
        becomes(zone);
        watch.look();
        EXPECT_EQ(zone_now(), std::string(zone) + " (" + text + ")");
        watch.look();
        EXPECT_EQ(zone_now(), std::string(zone) + " (" + text + ")");
    }
    std::filesystem::remove(folder / "here");
    watch.look();
    EXPECT_EQ(zone_now(), "+0545, UTC+05:45") << "it is being replaced: what was read stays";
}

TEST_F(TimeZone, IsNamedWithItsDistanceFromUtc) {
    ::setenv("TZ", "Europe/Berlin", 1);
    ZoneWatch watch;
    watch.look();
    EXPECT_EQ(zone_now(), "Europe/Berlin (CET, UTC+01:00)");
    EXPECT_EQ(time_text(judge_clock(kNow, true, {}, "/nowhere")), "2026-11-26 13:00 Europe/Berlin (CET, UTC+01:00)");
    ::setenv("TZ", "CET-1CEST,M3.5.0,M10.5.0/3", 1);
    ZoneWatch of_rules;
    of_rules.look();
    EXPECT_THAT(zone_now(), testing::EndsWith("(CET, UTC+01:00)"));
}

}  // namespace
}  // namespace quadrat::site
