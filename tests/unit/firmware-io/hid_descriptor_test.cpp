// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "firmware-io/hid/bindings.hpp"
#include "firmware-io/hid/report_reader.hpp"
#include "hid_specimens.hpp"

namespace quadrat::tests {
namespace {

using namespace firmware_io;
using namespace firmware_io::hid;

constexpr Usage kX = usage(page::kDesktop, 0x30);

std::string pressed_buttons(const ReportReader& reader, const Bindings& bindings) {
    const auto pressed = reader.pressed();
    std::string text;
    for (const Button button : kButtons) {
        const bool is_down = std::any_of(bindings.begin(), bindings.end(), [&](const Binding& binding) {
            return binding.button == button && std::binary_search(pressed.begin(), pressed.end(), binding.signal);
        });
        if (is_down) text.append(text.empty() ? "" : " ").append(name_of(button));
    }
    return text;
}

class EveryHidSpecimen : public testing::TestWithParam<HidSpecimen> {};

TEST_P(EveryHidSpecimen, IsUnderstoodWhole) {
    const HidSpecimen& specimen = GetParam();
    const HidLayout layout = parse_descriptor(bytes_of(specimen.descriptor));
    EXPECT_EQ(layout.trouble, "");
    EXPECT_EQ(layout.applications.size(), specimen.applications);
    EXPECT_EQ(layout.arrays.size(), specimen.arrays);
    const auto count = [&](ControlKind kind) {
        return static_cast<std::size_t>(std::count_if(layout.variables.begin(), layout.variables.end(),
                                                      [&](const Variable& v) { return v.kind == kind; }));
    };
    EXPECT_EQ(count(ControlKind::Button), specimen.buttons);
    EXPECT_EQ(count(ControlKind::Key), specimen.keys);
    EXPECT_EQ(count(ControlKind::Hat), specimen.hats);
    EXPECT_EQ(count(ControlKind::Axis), specimen.axes);
    EXPECT_GT(likelihood(layout), 0);
}

TEST_P(EveryHidSpecimen, ItsReportsPressWhatTheyShould) {
    ReportReader reader{parse_descriptor(bytes_of(GetParam().descriptor))};
    const Bindings bindings = default_bindings(reader.layout());
    for (const SpecimenReport& report : GetParam().reports) {
        reader.read(bytes_of(report.bytes));
        EXPECT_EQ(pressed_buttons(reader, bindings), report.pressed) << report.bytes;
    }
}

TEST_P(EveryHidSpecimen, OnlyWhatItCanSendIsBoundAndPressed) {
    ReportReader reader{parse_descriptor(bytes_of(GetParam().descriptor))};
    for (const Binding& binding : default_bindings(reader.layout()))
        EXPECT_TRUE(can_send(reader.layout(), binding.signal));
    for (const SpecimenReport& report : GetParam().reports) {
        reader.read(bytes_of(report.bytes));
        for (const HidSignal& signal : reader.pressed()) EXPECT_TRUE(can_send(reader.layout(), signal));
    }
}

INSTANTIATE_TEST_SUITE_P(Hid, EveryHidSpecimen, testing::ValuesIn(hid_specimens()),
                         [](const auto& specimen) { return std::string{specimen.param.name}; });

TEST(HidSpecimens, AreOfAtLeastTwentyFiveKinds) { EXPECT_GE(hid_specimens().size(), 25U); }

HidLayout axis(std::string_view limits_and_size) {
    return parse_descriptor(bytes_of("05 01 09 04 a1 01 09 30 " + std::string{limits_and_size} + " 95 01 81 02 c0"));
}

TEST(ReportReader, ClampsWhatLiesOutsideTheDeclaredRange) {
    ReportReader reader{axis("15 ff 25 01 75 02")};
    reader.read(bytes_of("02"));  // -2 where -1 is the least
    EXPECT_EQ(reader.pressed(), (std::vector<HidSignal>{{0, kX, SignalPart::Low}}));
    reader.read(bytes_of("01"));
    EXPECT_EQ(reader.pressed(), (std::vector<HidSignal>{{0, kX, SignalPart::High}}));
    reader.read(bytes_of("00"));
    EXPECT_TRUE(reader.pressed().empty());
}

TEST(ReportReader, AnAxisHasAStickyEndSoThatNoisePressesOnce) {
    ReportReader reader{axis("15 00 26 ff 00 75 08")};
    std::string seen;
    for (const char* value : {"80", "50", "40", "3f", "45", "50", "5e", "60", "70", "45", "c0", "b0", "90"}) {
        reader.read(bytes_of(value));
        seen += reader.pressed().empty() ? '.' : reader.pressed().front().part == SignalPart::Low ? 'L' : 'H';
    }
    EXPECT_EQ(seen, "...LLLL...HH.");
}

TEST(ReportReader, AnAxisMissingFromAShortReportIsNotPressed) {
    ReportReader reader{axis("15 00 26 ff 00 75 08")};
    reader.read({});
    EXPECT_TRUE(reader.pressed().empty());
}

TEST(ReportReader, AReportReplacesTheStateOfItsOwnControlsOnly) {
    ReportReader reader{parse_descriptor(bytes_of(hid_specimens()[3].descriptor))};
    reader.read(bytes_of("01 00 01 00"));
    reader.read(bytes_of("02 00 02 00"));
    EXPECT_EQ(reader.pressed().size(), 2U);
    reader.read(bytes_of("01 00 00 00"));
    EXPECT_EQ(reader.pressed().size(), 1U);
}

TEST(Likelihood, PrefersGamepadsToKeyboardsToMice) {
    const auto of = [](std::string_view name) {
        for (const HidSpecimen& specimen : hid_specimens())
            if (specimen.name == name) return likelihood(parse_descriptor(bytes_of(specimen.descriptor)));
        return -1;
    };
    EXPECT_GT(of("DualShock4"), of("BootKeyboard"));
    EXPECT_GT(of("BootKeyboard"), of("OneSwitchAsAMouse"));
    EXPECT_EQ(likelihood(parse_descriptor(bytes_of("06 00 ff 09 01 a1 01 09 02 15 00 26 ff 00 75 08 95 40 81 02 c0"))),
              0);
}

TEST(ParseDescriptor, SaysWhatIsWrongAndKeepsWhatStoodBefore) {
    const auto trouble = [](std::string_view bytes) { return parse_descriptor(bytes_of(bytes)).trouble; };
    EXPECT_EQ(trouble("05 01 09"), "an item is cut short");
    EXPECT_EQ(trouble("fe ff"), "a long item is cut short");
    EXPECT_EQ(trouble("c0"), "a collection ends that never began");
    EXPECT_EQ(trouble("b4"), "it pops what it never pushed");
    EXPECT_EQ(trouble("85 00"), "a report ID is not 1 to 255");
    EXPECT_EQ(trouble("09 04 a1 01 77 ff ff ff ff 97 ff ff ff ff 81 02"), "a report is longer than 16384 bytes");
    EXPECT_EQ(parse_descriptor(std::vector<std::uint8_t>(5000, 0x04)).trouble, "it is longer than 4096 bytes");
    const HidLayout half =
        parse_descriptor(bytes_of("05 01 09 05 a1 01 05 09 19 01 29 08 15 00 25 01 75 01 95 08 81 02 27 00"));
    EXPECT_EQ(half.variables.size(), 8U);
}

// Bytes flipped, cut out, doubled and invented, from a fixed seed; then reports as wild, of every length.
TEST(ParseDescriptor, SurvivesThirtyThousandMalformedDescriptorsAndReports) {
    std::mt19937 random{1972};
    const auto byte = [&] { return static_cast<std::uint8_t>(random()); };
    std::size_t usable = 0;
    for (int round = 0; round < 30'000; ++round) {
        std::vector<std::uint8_t> bytes;
        if (round % 4 == 0) {
            bytes.resize(random() % 300);
            std::generate(bytes.begin(), bytes.end(), byte);
        } else {
            bytes = bytes_of(hid_specimens()[random() % hid_specimens().size()].descriptor);
            for (auto wounds = random() % 6; wounds > 0 && !bytes.empty(); --wounds) {
                const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(random() % bytes.size());
                if (random() % 3 == 0)
                    *at = byte();
                else if (random() % 2 == 0)
                    bytes.erase(at);
                else
                    bytes.insert(at, byte());
            }
        }
        ReportReader reader{parse_descriptor(bytes)};
        usable += likelihood(reader.layout()) > 0;
        for (int i = 0; i < 3; ++i) {
            std::vector<std::uint8_t> report(random() % 70);
            std::generate(report.begin(), report.end(), byte);
            reader.read(report);
            for (const HidSignal& signal : reader.pressed()) ASSERT_TRUE(can_send(reader.layout(), signal));
        }
    }
    EXPECT_GT(usable, 10'000U) << "the wounds are too deep to reach the code";
}

}  // namespace
}  // namespace quadrat::tests
