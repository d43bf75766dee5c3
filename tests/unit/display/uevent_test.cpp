// SPDX-License-Identifier: Apache-2.0
#include "display/kms/uevent.hpp"

#include <gtest/gtest.h>

#include "base/seed.hpp"

namespace quadrat::display {
namespace {

std::string message(std::initializer_list<std::string_view> lines) {
    std::string bytes;
    for (const std::string_view line : lines) bytes.append(line).push_back('\0');
    return bytes;
}

TEST(ReadUevent, HearsAPlugOnThisKernelAndOnOlderOnes) {
    const std::string today = message({"change@/devices/platform/gpu/drm/card1", "ACTION=change",
                                       "DEVPATH=/devices/platform/gpu/drm/card1", "SUBSYSTEM=drm", "HOTPLUG=1",
                                       "CONNECTOR=32", "DEVNAME=dri/card1", "DEVTYPE=drm_minor", "SEQNUM=4711"});
    EXPECT_EQ(read_uevent(today), (Uevent{CardEvent::PlugMoved, "dri/card1"}));
    const std::string before =
        message({"change@/devices/x", "ACTION=change", "SUBSYSTEM=drm", "HOTPLUG=1", "DEVNAME=dri/card0"});
    EXPECT_EQ(read_uevent(before), (Uevent{CardEvent::PlugMoved, "dri/card0"}));
}

TEST(ReadUevent, HearsCardsComeAndGoButNotTheirRenderNodesAndConnectors) {
    const auto told = [](std::string_view action, std::string_view type, std::string_view node) {
        return read_uevent(message({"x@y", action, "SUBSYSTEM=drm", type, node}));
    };
    EXPECT_EQ(told("ACTION=add", "DEVTYPE=drm_minor", "DEVNAME=dri/card0"), (Uevent{CardEvent::Appeared, "dri/card0"}));
    EXPECT_EQ(told("ACTION=remove", "DEVTYPE=drm_minor", "DEVNAME=dri/card0"),
              (Uevent{CardEvent::Removed, "dri/card0"}));
    EXPECT_EQ(told("ACTION=add", "DEVTYPE=drm_minor", "DEVNAME=dri/renderD128"), std::nullopt);
    EXPECT_EQ(told("ACTION=add", "DEVTYPE=drm_connector", ""), std::nullopt);
    EXPECT_EQ(told("ACTION=bind", "DEVTYPE=drm_minor", "DEVNAME=dri/card0"), std::nullopt);
}

TEST(ReadUevent, IsDeafToEverythingElse) {
    EXPECT_EQ(read_uevent(""), std::nullopt);
    EXPECT_EQ(read_uevent(message({"add@/usb", "ACTION=add", "SUBSYSTEM=usb", "HOTPLUG=1"})), std::nullopt);
    EXPECT_EQ(read_uevent("libudev\0\xfe\xed\xca\xfe"), std::nullopt);
    EXPECT_EQ(read_uevent(message({"change@/x", "ACTION=change", "SUBSYSTEM=drm", "LEASE=1"})), std::nullopt);
    EXPECT_EQ(read_uevent("SUBSYSTEM=drm"), std::nullopt) << "cut short, without its end";
}

TEST(ReadUevent, SurvivesAnyBytes) {
    base::RandomStream random{base::Seed{3}};
    const std::string good = message({"change@/x", "ACTION=change", "SUBSYSTEM=drm", "HOTPLUG=1", "DEVNAME=dri/card0"});
    for (int i = 0; i < 5000; ++i) {
        std::string bytes = good.substr(0, random.below(static_cast<std::uint32_t>(good.size() + 1)));
        for (char& byte : bytes)
            if (random.below(20) == 0) byte = static_cast<char>(random.bits());
        const auto read = read_uevent(bytes);
        EXPECT_LE(read ? read->node.size() : 0, bytes.size());
    }
}

}  // namespace
}  // namespace quadrat::display
