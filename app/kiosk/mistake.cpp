// SPDX-License-Identifier: Apache-2.0
#include "kiosk/mistake.hpp"

#include <fmt/format.h>

namespace quadrat::kiosk {
namespace {

std::string lines_of(const std::vector<Mistake>& mistakes) {
    std::string lines;
    for (const Mistake& mistake : mistakes) {
        if (!lines.empty()) lines += '\n';
        lines += to_text(mistake);
    }
    return lines;
}

}  // namespace

std::string to_text(const Mistake& mistake) {
    return fmt::format("{}{}: {}{}{}", mistake.file, mistake.line > 0 ? fmt::format(":{}", mistake.line) : "",
                       mistake.what, mistake.remedy.empty() ? "" : "; ", mistake.remedy);
}

Mistake mistake_from(const std::string& file, int line, std::string_view message) {
    constexpr std::string_view kBetween = "; ";
    const std::size_t end = message.rfind(kBetween);
    if (end == std::string_view::npos) return {file, line, std::string(message), ""};
    return {file, line, std::string(message.substr(0, end)), std::string(message.substr(end + kBetween.size()))};
}

SettingsError::SettingsError(std::vector<Mistake> mistakes)
    : base::InputError(lines_of(mistakes)), mistakes_(std::move(mistakes)) {}

}  // namespace quadrat::kiosk
