// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/keyboard/keyboard_buttons.hpp"

#include <gmock/gmock.h>

#include "firmware-io/lamps.hpp"

namespace quadrat::firmware_io {
namespace {

using namespace std::chrono_literals;

TEST(Keyboard, EveryButtonHasItsLetterItsDigitAndBackItsKeys) {
    for (const auto& [keys, button] : {std::pair{"Aa1", Button::A}, std::pair{"Bb2", Button::B},
                                       std::pair{"Cc3", Button::C}, std::pair{"Dd4", Button::D}})
        for (const char* key = keys; *key != 0; ++key) EXPECT_EQ(keyboard::button_for_key(*key), button) << *key;
    for (const char key : {keyboard::kEscape, keyboard::kBackspace, keyboard::kArrowLeft})
        EXPECT_EQ(keyboard::button_for_key(key), Button::Back);
    for (int key = -128; key < 0; ++key) EXPECT_FALSE(keyboard::button_for_key(static_cast<char>(key)));
    EXPECT_FALSE(keyboard::button_for_key('5'));
}

TEST(Keyboard, TwoKeysOfOneButtonAreOnePress) {
    keyboard::KeyboardButtons buttons;
    buttons.key('A', Motion::Down, 10ms);
    buttons.key('1', Motion::Down, 20ms);
    buttons.key('A', Motion::Up, 100ms);
    EXPECT_EQ(buttons.poll(500ms).size(), 1U);
    buttons.key('1', Motion::Up, 600ms);
    EXPECT_EQ(buttons.poll(1s).size(), 1U);
}

TEST(Keyboard, AKeyOfTheFutureWaitsForItsTime) {
    keyboard::KeyboardButtons buttons;
    buttons.key('C', Motion::Down, 2s);
    EXPECT_TRUE(buttons.poll(1s).empty());
    EXPECT_EQ(buttons.next_event_at(), 2s);
    EXPECT_EQ(buttons.poll(2s).size(), 1U);
}

TEST(Lamps, BlinkSlowerThanThreeTimesASecondAndBreatheWithoutGoingDark) {
    int flashes = 0;
    for (Instant at = 0s; at < 10s; at += 1ms) {
        flashes += is_lamp_lit(LampPattern::Blinking, at + 1ms) && !is_lamp_lit(LampPattern::Blinking, at);
        EXPECT_GE(lamp_brightness(LampPattern::Breathing, at), 0.1f);
        EXPECT_LE(lamp_brightness(LampPattern::Breathing, at), 1.0f);
        EXPECT_FALSE(is_lamp_lit(LampPattern::Off, at));
        EXPECT_TRUE(is_lamp_lit(LampPattern::Steady, at));
    }
    EXPECT_GT(flashes, 8);
    EXPECT_LT(flashes, 30);
}

TEST(Button, NamesAreReadInAnyCase) {
    for (const Button button : kButtons) EXPECT_EQ(button_named(name_of(button)), button);
    EXPECT_EQ(button_named("BACK"), Button::Back);
    EXPECT_EQ(button_named("E"), std::nullopt);
    EXPECT_EQ(button_named(""), std::nullopt);
}

}  // namespace
}  // namespace quadrat::firmware_io
