// SPDX-License-Identifier: Apache-2.0
#include "site/mistake.hpp"

#include <fmt/format.h>

namespace quadrat::site {
namespace {

std::string lines_of(const std::vector<Mistake>& mistakes) {
    std::string lines;
    for (const Mistake& mistake : mistakes) {
        if (!lines.empty()) lines += '\n';
        lines += to_text(mistake);
    }
    return lines;
}

std::string escaped(const std::string& text) {
    std::string line;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '\n')
            line += "\\n";
        else if (byte < ' ' || byte == 127)
            line += fmt::format("\\x{:02x}", byte);
        else
            line += c;
    }
    return line;
}

}  // namespace

Mistake on_one_line(Mistake mistake) {
    mistake.what = escaped(mistake.what);
    mistake.remedy = escaped(mistake.remedy);
    return mistake;
}

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

}  // namespace quadrat::site
