// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "firmware-io/hid/bindings.hpp"
#include "firmware-io/text.hpp"
#include "hid_specimens.hpp"
#include "support/process.hpp"

namespace quadrat::tests {
namespace {

using namespace firmware_io;
using namespace firmware_io::hid;

struct RealDevice {
    std::string name;
    std::size_t applications, buttons, keys, hats, axes, arrays;
    std::vector<std::uint8_t> descriptor;
};

std::string spaced(std::string_view digits) {
    std::string text;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2) text.append(digits.substr(i, 2)).append(" ");
    return text;
}

std::vector<RealDevice> real_devices() {
    const std::string text = contents_of(QUADRAT_SOURCE_DIR "/tests/unit/firmware-io/real_descriptors.txt");
    std::vector<RealDevice> devices;
    for (const std::string_view line : split(text, '\n')) {
        if (line.empty() || line.front() == '#') continue;
        const auto parts = split(line, ':');
        RealDevice device{std::string{parts.at(0)}, 0, 0, 0, 0, 0, 0, bytes_of(spaced(trimmed(parts.at(2))))};
        std::istringstream counts{std::string{parts.at(1)}};
        counts >> device.applications >> device.buttons >> device.keys >> device.hats >> device.axes >> device.arrays;
        devices.push_back(std::move(device));
    }
    return devices;
}

class EveryRealDevice : public testing::TestWithParam<RealDevice> {};

TEST_P(EveryRealDevice, HasTheControlsThatAnotherProgramCounts) {
    const RealDevice& device = GetParam();
    const HidLayout layout = parse_descriptor(device.descriptor);
    const auto count = [&](ControlKind kind) {
        return static_cast<std::size_t>(std::count_if(layout.variables.begin(), layout.variables.end(),
                                                      [&](const Variable& v) { return v.kind == kind; }));
    };
    EXPECT_EQ(layout.trouble, "");
    EXPECT_EQ(layout.applications.size(), device.applications);
    EXPECT_EQ(count(ControlKind::Button), device.buttons);
    EXPECT_EQ(count(ControlKind::Key), device.keys);
    EXPECT_EQ(count(ControlKind::Hat), device.hats);
    EXPECT_EQ(count(ControlKind::Axis), device.axes);
    EXPECT_EQ(layout.arrays.size(), device.arrays);
}

// A pad or a keyboard can be played with at once; what has nothing to press is not mistaken for one that has.
TEST_P(EveryRealDevice, CanBePressedIfThereIsAnythingToPress) {
    const RealDevice& device = GetParam();
    const HidLayout layout = parse_descriptor(device.descriptor);
    const Bindings bindings = default_bindings(layout);
    const bool has_something = device.buttons + device.keys + device.hats + device.arrays > 0;
    EXPECT_EQ(likelihood(layout) > 0, has_something);
    EXPECT_EQ(bindings.empty(), !has_something);
    for (const Binding& binding : bindings) EXPECT_TRUE(can_send(layout, binding.signal));
    if (device.buttons < 5) return;
    for (const Button button : kButtons)
        EXPECT_TRUE(std::any_of(bindings.begin(), bindings.end(), [&](const Binding& b) { return b.button == button; }))
            << name_of(button);
}

INSTANTIATE_TEST_SUITE_P(Hid, EveryRealDevice, testing::ValuesIn(real_devices()),
                         [](const auto& device) { return device.param.name; });

TEST(RealDevices, AreOfAtLeastTwentyFiveKinds) { EXPECT_GE(real_devices().size(), 25U); }

}  // namespace
}  // namespace quadrat::tests
