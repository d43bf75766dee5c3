// SPDX-License-Identifier: Apache-2.0
#include "doctor/diagnosis_crash.hpp"

#include <gmock/gmock.h>

#include "support/process.hpp"

namespace {

using namespace quadrat::doctor;
using namespace std::chrono_literals;
using std::chrono::system_clock;

constexpr uid_t kExhibit = 995;
const quadrat::machine::Account kAccount{"quadrat", kExhibit, {}};

std::string core_of(const std::string& thread, uid_t user, system_clock::time_point at) {
    const auto us = std::chrono::duration_cast<std::chrono::microseconds>(at.time_since_epoch()).count();
    return "core." + thread + "." + std::to_string(user) + ".0123456789abcdef0123456789abcdef.812." +
           std::to_string(us) + ".zst";
}

TEST(Crashes, TheLastOneOfTheExhibitIsNamedWhateverThreadItWas) {
    const quadrat::tests::TemporaryFolder folder;
    const system_clock::time_point now(1'790'000'000s);
    folder.write(core_of("quadrat", kExhibit, now - 48h), "");
    folder.write(core_of("mesa:gl.0", kExhibit, now - 1h), "");
    folder.write(core_of("bash", 0, now), "");
    folder.write("core.quadrat.995.short.1.2", "");
    const auto found = examine_crashes(folder.path(), kAccount, now);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().health, Health::Doubtful);
    const std::time_t last = system_clock::to_time_t(now - 1h);
    char day[32] = {};
    std::strftime(day, sizeof day, "%Y-%m-%d %H:%M", std::localtime(&last));
    EXPECT_THAT(found.front().what, testing::HasSubstr(day));
    EXPECT_THAT(found.front().remedy, testing::HasSubstr("coredumpctl info"));
}

TEST(Crashes, OneThatIsLongPastMakesNobodyDoubt) {
    const quadrat::tests::TemporaryFolder folder;
    const system_clock::time_point now(1'790'000'000s);
    folder.write(core_of("quadrat", kExhibit, now - 24h * 8), "");
    const auto found = examine_crashes(folder.path(), kAccount, now);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().health, Health::Good);
}

TEST(Crashes, NothingIsSaidWhereNoneIsKept) {
    const quadrat::tests::TemporaryFolder folder;
    const system_clock::time_point now(1'790'000'000s);
    EXPECT_TRUE(examine_crashes(folder.path(), kAccount, now).empty());
    EXPECT_TRUE(examine_crashes(folder / "nowhere", kAccount, now).empty());
    folder.write(core_of("quadrat", kExhibit, now), "");
    EXPECT_TRUE(examine_crashes(folder.path(), std::nullopt, now).empty());
}

}  // namespace
