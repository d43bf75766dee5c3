// SPDX-License-Identifier: Apache-2.0
#include "commands/scripted_visitor.hpp"

#include "firmware-io/scripted/scripted_buttons.hpp"

namespace quadrat::commands {

using firmware_io::Button;

std::unique_ptr<firmware_io::ButtonSource> scripted_visitor(int rounds, base::Seed seed) {
    using std::chrono::milliseconds;
    constexpr std::uint32_t kChoices = 4;
    constexpr int kQuestions = 3;
    base::RandomStream liking{seed.child("visitor")};
    firmware_io::scripted::ScriptWriter writer;
    writer.wait(milliseconds{2500}).press(Button::A);
    for (int i = 0; i < rounds * kQuestions; ++i) {
        const auto choice = static_cast<Button>(liking.below(kChoices));
        writer.wait(milliseconds{1200} + milliseconds{liking.below(1800)}).press(choice);
    }
    return std::make_unique<firmware_io::scripted::ScriptedButtons>(writer.script());
}

}  // namespace quadrat::commands
