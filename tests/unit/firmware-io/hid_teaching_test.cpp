// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/hid/teaching.hpp"

#include <gmock/gmock.h>

#include "fake_hid.hpp"

namespace quadrat::tests {
namespace {

using namespace firmware_io;
using namespace firmware_io::hid;
using testing::HasSubstr;

struct TwoBoards {
    std::shared_ptr<FakeHidDevice> left = five_button_device(), right = five_button_device();
    TwoBoards() {
        right->facts.path = "/dev/hidraw1";
        right->facts.identity.port = "usb-0000:00:14.0-2/input0";
    }
    FakeHidHost host() const { return FakeHidHost{{left, right}}; }
};

void press(FakeHidDevice& device, Teaching& teaching, unsigned bit) {
    device.send({static_cast<std::uint8_t>(1U << bit)});
    teaching.poll();
    device.send({0});
    teaching.poll();
}

TEST(Teaching, TheBoardThatIsPressedFirstIsThePupilAndIsKeptByItsPort) {
    TwoBoards boards;
    FakeHidHost host = boards.host();
    Teaching teaching{host, {}};
    ASSERT_TRUE(teaching.has_devices());
    EXPECT_EQ(teaching.asked(), Button::A);
    press(*boards.right, teaching, 4);
    ASSERT_TRUE(teaching.pupil().has_value());
    EXPECT_EQ(teaching.pupil()->path, "/dev/hidraw1");
    press(*boards.left, teaching, 0);
    EXPECT_EQ(teaching.asked(), Button::B) << "the other board is not being taught";
    for (const unsigned bit : {3U, 2U, 1U}) press(*boards.right, teaching, bit);
    teaching.skip();
    EXPECT_EQ(teaching.asked(), std::nullopt);
    const HidMapping mapping = teaching.mapping();
    EXPECT_EQ(mapping.port, "usb-0000:00:14.0-2/input0");
    ASSERT_EQ(mapping.bindings.size(), 4U);
    EXPECT_EQ(mapping.bindings[0].button, Button::A);
    EXPECT_EQ(mapping.bindings[0].signal.usage, usage(page::kButton, 5));

    HidButtons buttons{std::make_unique<FakeHidHost>(FakeHidDevices{boards.left, boards.right}), {}, {}, {mapping}};
    buttons.poll(Instant{0});
    boards.right->send({0x10});
    const auto edges = buttons.poll(std::chrono::seconds{1});
    ASSERT_EQ(edges.size(), 1U);
    EXPECT_EQ(edges[0].button, Button::A);
}

TEST(Teaching, SaysWhatThePressWasNot) {
    auto board = five_button_device();
    FakeHidHost host{{board}};
    Teaching teaching{host, {}};
    press(*board, teaching, 0);
    press(*board, teaching, 0);
    EXPECT_THAT(teaching.trouble(), HasSubstr("is button A already"));
    EXPECT_EQ(teaching.asked(), Button::B);
}

TEST(Teaching, EndsWhenThePupilIsUnplugged) {
    auto board = five_button_device();
    FakeHidHost host{{board}};
    Teaching teaching{host, {}};
    press(*board, teaching, 0);
    board->unplug();
    teaching.poll();
    EXPECT_EQ(teaching.asked(), std::nullopt);
    EXPECT_THAT(teaching.trouble(), HasSubstr("was unplugged"));
}

TEST(Teaching, NamesWhatIsMissing) {
    FakeHidHost nobody{{}};
    EXPECT_THAT(Teaching(nobody, {}).trouble(), HasSubstr("is not plugged in"));
    auto board = five_button_device();
    board->refusal = "Permission denied";
    FakeHidHost closed{{board}};
    const Teaching teaching{closed, {}};
    EXPECT_FALSE(teaching.has_devices());
    EXPECT_THAT(teaching.trouble(), HasSubstr("/dev/hidraw0 cannot be opened (Permission denied)"));
}

}  // namespace
}  // namespace quadrat::tests
