// SPDX-License-Identifier: Apache-2.0
#include "staff/caretaker.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "firmware-io/merged_buttons.hpp"
#include "support/process.hpp"
#include "unit/display/named_screen.hpp"

namespace quadrat::staff {
namespace {

using namespace std::chrono_literals;
using testing::Contains;
using testing::HasSubstr;

TEST(Caretaker, NamesTheScreenThatIsThereNow) {
    const tests::TemporaryFolder folder;
    site::Configuration configuration;
    firmware_io::MergedButtons buttons{{}};
    Panel panel(buttons);
    Ladder ladder("", folder.path(), Seconds{0});
    tests::NamedScreen screen("no GPU", "no graphics card yet");
    Caretaker caretaker({configuration, {}, folder.path(), folder.path(), ladder, screen});
    caretaker.step_figures();
    std::ignore = caretaker.look(panel, {}, 1s);
    ASSERT_NE(caretaker.board(), nullptr);
    EXPECT_THAT(caretaker.board()->lines, Contains(HasSubstr("no graphics card yet")));
    screen.becomes("V3D 4.2", "HDMI-A-1 1920x1080@60");
    std::ignore = caretaker.look(panel, {}, 2s);
    EXPECT_THAT(caretaker.board()->lines, Contains("V3D 4.2, HDMI-A-1 1920x1080@60"));
}

}  // namespace
}  // namespace quadrat::staff
