// SPDX-License-Identifier: Apache-2.0
#include "staff/service_screen.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "site/wall_clock.hpp"

namespace quadrat::staff {
namespace {

using firmware_io::Button;
using firmware_io::Instant;
using firmware_io::LampPattern;

constexpr std::size_t kFaultsShown = 6;
constexpr std::size_t kLongestLine = 110;  // bytes; longer ones would leave the screen

std::string shortened(std::string line) {
    if (line.size() <= kLongestLine) return line;
    std::size_t end = kLongestLine;
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xc0U) == 0x80U) --end;  // not within a letter
    return line.substr(0, end) + " …";
}

std::string span(std::chrono::seconds s) {
    const auto minutes = s.count() / 60;
    if (minutes < 120) return fmt::format("{} min", minutes);
    if (minutes < 48 * 60) return fmt::format("{} h", minutes / 60);
    return fmt::format("{} days", minutes / 60 / 24);
}

std::string machine_line(const Vitals& vitals) {
    std::string line = fmt::format("memory {:.0f} MB", vitals.machine.memory_mb);
    if (vitals.machine.temperature_c) line += fmt::format(" · {:.0f} °C", *vitals.machine.temperature_c);
    const auto& is_throttled = vitals.machine.is_throttled;
    if (!is_throttled) return line + " · throttling not known";
    return line + (*is_throttled ? " · THROTTLED by heat or low voltage" : " · not throttled");
}

std::string clock_line(const Vitals& vitals) {
    return fmt::format("{} · {}", site::time_text(vitals.wall),
                       vitals.wall.is_trusted ? vitals.wall.source : "clock NOT TRUSTED");
}

std::string opening_line(const Vitals& vitals) {
    return vitals.wall.is_trusted ? vitals.opening : fmt::format("{} · {}", vitals.opening, vitals.wall.doubt);
}

std::string disk_line(const Vitals& vitals) {
    std::string line = vitals.free_mb ? fmt::format("disk {:.0f} MB left", *vitals.free_mb) : "disk MISSING";
    line += fmt::format(" · {:.1f} MB written", static_cast<double>(vitals.machine.written_bytes) / 1e6);
    if (!vitals.state_trouble.empty()) line += " · " + vitals.state_trouble;
    return line;
}

std::string sound_line(const Vitals& vitals) {
    if (!vitals.sound.trouble.empty()) return "NO SOUND: " + vitals.sound.trouble;
    return fmt::format("sound plays · {} gaps", vitals.sound.underruns);
}

std::string live_line(const Vitals& vitals) {
    std::string line = "now ";
    for (const Button button : firmware_io::kButtons)
        line += fmt::format(" {}{}", name_of(button), vitals.is_closed[index_of(button)] ? " ●" : " ○");
    return line;
}

std::string frames_line(const Vitals& vitals) {
    return fmt::format(
        "{:.0f} frames/s · {} late of {} · detail {:.2f} (α {:.2f}) · {} thousand triangles in {} draws · views at "
        "{:.0f} %{}",
        vitals.frames.per_second, vitals.frames.late, vitals.frames.frames, vitals.level, vitals.alpha,
        (vitals.triangles + 500) / 1000, vitals.draws, 100 * vitals.scale, vitals.samples > 1 ? " · smooth edges" : "");
}

// Those of this run, and where there are few, the last ones of before: a reboot forgets none.
std::vector<std::string> last_faults(const Vitals& vitals) {
    const std::size_t now = std::min(kFaultsShown, vitals.faults.size());
    const std::size_t before = std::min(kFaultsShown - now, vitals.earlier_faults.size());
    std::vector<std::string> faults;
    for (std::size_t i = vitals.earlier_faults.size() - before; i < vitals.earlier_faults.size(); ++i)
        faults.push_back("earlier: " + vitals.earlier_faults[i]);
    faults.insert(faults.end(), vitals.faults.end() - static_cast<std::ptrdiff_t>(now), vitals.faults.end());
    return faults;
}

}  // namespace

void ServiceScreen::open(Instant now) {
    *this = {};
    is_open_ = true;
    last_press_ = now;
}

bool ServiceScreen::is_open(Instant now) {
    if (is_open_ && now - last_press_ >= kPatience) *this = {};
    return is_open_;
}

bool ServiceScreen::is_sure(Button button, Instant now) const {
    return asked_ == button && now - last_press_ <= kSureWithin;
}

std::optional<StaffWish> ServiceScreen::press(Button button, Instant now) {
    const bool is_said_twice = is_sure(button, now);
    last_press_ = now;
    asked_.reset();
    told_.clear();
    switch (button) {
        case Button::A:
            is_testing_lamps_ = !is_testing_lamps_;
            return std::nullopt;
        case Button::C:
            told_ = "A picture was taken.";
            return StaffWish::Picture;
        case Button::Back:
            *this = {};
            return std::nullopt;
        case Button::B:
        case Button::D:
            break;
    }
    if (is_said_twice) {
        told_ = button == Button::B ? "Restarting …" : "Shutting down …";
        return button == Button::B ? StaffWish::Restart : StaffWish::ShutDown;
    }
    asked_ = button;
    told_ = button == Button::B ? "Press B again to restart the exhibit." : "Press D again to shut the machine down.";
    return std::nullopt;
}

firmware_io::Lamps ServiceScreen::lamps(Instant now) const {
    return is_testing_lamps_ ? lamp_test(now) : firmware_io::Lamps{};
}

firmware_io::Lamps lamp_test(Instant now) {
    firmware_io::Lamps lamps{};
    constexpr Instant kEach = std::chrono::milliseconds{500};
    const auto turn = static_cast<std::size_t>((now / kEach) % (lamps.size() + 1));
    if (turn == lamps.size())
        lamps.fill(LampPattern::Steady);
    else
        lamps[turn] = LampPattern::Steady;
    return lamps;
}

stage::Board figures_board(const Vitals& vitals, bool has_wires) {
    return {"", {frames_line(vitals), vitals.display}, stage::Board::Cover::Strip, has_wires};
}

stage::Board ServiceScreen::board(const Vitals& vitals, Instant now) const {
    stage::Board board;
    board.title = fmt::format("Quadrat {} · {}{}", vitals.version, vitals.machine.name,
                              vitals.mode == Mode::Safe ? " · SAFE MODE" : "");
    auto& lines = board.lines;
    lines.push_back(fmt::format(
        "address {} · running {}",
        vitals.machine.addresses.empty() ? "none" : fmt::format("{}", fmt::join(vitals.machine.addresses, " ")),
        span(vitals.running)));
    lines.push_back(clock_line(vitals));
    lines.push_back(opening_line(vitals));
    lines.push_back(vitals.display);
    lines.push_back(frames_line(vitals));
    lines.push_back(machine_line(vitals));
    lines.push_back(disk_line(vitals));
    if (vitals.sound.is_wanted) lines.push_back(sound_line(vitals));
    if (!vitals.postcard_trouble.empty()) lines.push_back("NO POSTCARD: " + vitals.postcard_trouble);
    lines.push_back(fmt::format("{} visits · {} presses · {} failures in ten minutes", vitals.visits, vitals.presses,
                                vitals.failures));
    lines.push_back(live_line(vitals));
    const bool is_absent = vitals.buttons.presence == firmware_io::Presence::Absent;
    if (is_absent) lines.push_back("BUTTONS MISSING: " + vitals.buttons.reason);
    for (const auto& finding : vitals.findings)
        lines.push_back(fmt::format("button {} is {}", name_of(finding.button), name_of(finding.ailment)));
    const auto settings = lines_for_staff(vitals.settings);
    lines.insert(lines.end(), settings.begin(), settings.end());
    for (std::string& fault : last_faults(vitals)) lines.push_back(std::move(fault));
    lines.emplace_back();
    lines.emplace_back(is_testing_lamps_ ? "A: end the lamp test   B: restart   C: picture   D: shut down   Back: leave"
                                         : "A: lamp test   B: restart   C: picture   D: shut down   Back: leave");
    if (!told_.empty() && now - last_press_ <= kSureWithin) lines.push_back(told_);
    for (std::string& line : lines) line = shortened(std::move(line));
    return board;
}

}  // namespace quadrat::staff
