// SPDX-License-Identifier: Apache-2.0
#include "kiosk/staff/caretaker.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware-io/merged_buttons.hpp"
#include "support/process.hpp"
#include "unit/display/named_screen.hpp"

namespace quadrat::kiosk::staff {
namespace {

using namespace std::chrono_literals;
using testing::Contains;
using testing::HasSubstr;

exhibit::WallTime no_time() { return {}; }

TEST(Caretaker, NamesTheScreenThatIsThereNow) {
    const tests::TemporaryFolder folder;
    Configuration configuration;
    configuration.picture.land_samples = 65;
    Show show(configuration, {base::Seed{1}, {1, {65, 64, 128}}, no_time, no_time, ""},
              exhibit::Archive::open(folder.path(), {}).archive);
    firmware_io::MergedButtons buttons{{}};
    Panel panel(buttons);
    Ladder ladder("", folder.path(), Seconds{0});
    tests::NamedScreen screen("no GPU", "no graphics card yet");
    Caretaker caretaker({configuration, {}, folder.path(), folder.path(), ladder, screen});
    caretaker.step_figures();
    caretaker.look(panel, show, 1s);
    ASSERT_NE(caretaker.board(), nullptr);
    EXPECT_THAT(caretaker.board()->lines, Contains(HasSubstr("no graphics card yet")));
    screen.becomes("V3D 4.2", "HDMI-A-1 1920x1080@60");
    caretaker.look(panel, show, 2s);
    EXPECT_THAT(caretaker.board()->lines, Contains("V3D 4.2, HDMI-A-1 1920x1080@60"));
}

}  // namespace
}  // namespace quadrat::kiosk::staff
