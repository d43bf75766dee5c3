// SPDX-License-Identifier: Apache-2.0
#include "commands/exhibits_screen.hpp"

#include <nlohmann/json.hpp>
#include <system_error>

#include "base/error.hpp"
#include "base/file.hpp"
#include "staff/presence.hpp"

namespace quadrat::commands {

namespace fs = std::filesystem;

std::optional<projector::Wanted> ExhibitsScreen::wanted() {
    if (!staff::is_exhibit_present(runtime_)) return std::nullopt;
    std::error_code error;
    const auto written = fs::last_write_time(runtime_ / "health.json", error);
    if (error) return std::nullopt;
    if (written != read_at_) read();
    read_at_ = written;
    return wanted_;
}

void ExhibitsScreen::read() {
    constexpr std::size_t kLargest = 1U << 20U;
    try {
        const auto health = nlohmann::json::parse(base::read_file(runtime_ / "health.json", kLargest), nullptr, false);
        const auto screen = health.is_object() ? health.value("screen", nlohmann::json()) : nlohmann::json();
        wanted_.reset();
        if (screen == "dark") wanted_ = projector::Wanted::Off;
        if (screen == "shows" || screen == "card") wanted_ = projector::Wanted::On;
    } catch (const base::InputError&) {
        wanted_.reset();  // it is being replaced; the next look finds it
    }
}

}  // namespace quadrat::commands
