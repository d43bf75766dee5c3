// SPDX-License-Identifier: Apache-2.0
#include "site/parse_toml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace quadrat::site {
namespace {

constexpr std::size_t kMostMistakes = 40;
constexpr std::string_view kUnread = "unread-";  // tables whose own name could not be read

// What a line is that can be left out without a change to what the lines around it mean.
enum class Line { Key, Header, Other };

Line kind_of(std::string_view line) {
    const auto count = [&](char c) { return std::ranges::count(line, c); };
    const auto has = [&](std::string_view part) { return line.find(part) != std::string_view::npos; };
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos) return Line::Other;
    if (line[first] == '[' && !has("=")) return Line::Header;
    const std::size_t equals = line.find('=');
    const bool has_key =
        equals != std::string_view::npos && line.substr(0, equals).find_first_of("[]{},#") == std::string_view::npos;
    const bool is_closed = count('[') == count(']') && count('{') == count('}');
    return has_key && is_closed && !has("\"\"\"") && !has("'''") ? Line::Key : Line::Other;
}

std::string remedy_for(std::string_view description) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kRemedies{{
        {"could not determine value type", "text stands in quotation marks: KEY = \"…\""},
        {"redefine existing table", "each [table] stands in the file once: move its keys to the first"},
        {"redefine existing", "each key stands in its table once: delete one of them"},
        {"parsing table header", "write [TABLE] on a line of its own"},
        {"parsing string", "text begins and ends with a quotation mark, on one line: KEY = \"…\""},
        {"parsing array", "a list is written [\"…\", \"…\"]"},
        {"expected value", "write KEY = VALUE, or delete the line"},
        {"utf-8", "save the file as UTF-8"},
    }};
    for (const auto& [said, remedy] : kRemedies)
        if (description.find(said) != std::string_view::npos) return std::string(remedy);
    return "write KEY = VALUE";
}

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines{""};
    for (const char c : text) {
        if (c == '\n')
            lines.emplace_back();
        else
            lines.back() += c;
    }
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

// Its mistake; nothing: it is TOML, and now in `root`.
std::optional<Mistake> parse(const std::string& text, const std::string& source, toml::table& root) {
    try {
        root = toml::parse(text, source);
        return std::nullopt;
    } catch (const toml::parse_error& error) {
        const std::string why(error.description());
        return Mistake{source, static_cast<int>(error.source().begin.line), "this cannot be read: " + why,
                       remedy_for(why)};
    }
}

// Without the line. False: then the lines after it would mean something else.
bool leave_out(std::vector<std::string>& lines, const Mistake& mistake) {
    const auto index = static_cast<std::size_t>(std::max(mistake.line, 1) - 1);
    if (index >= lines.size()) return false;
    const Line kind = kind_of(lines[index]);
    const bool is_within = mistake.what.find("parsing array") != std::string::npos ||
                           mistake.what.find("parsing inline table") != std::string::npos;
    if (kind == Line::Other || is_within) return false;
    lines[index] = kind == Line::Header ? fmt::format("[{}{}]", kUnread, mistake.line) : "";
    return true;
}

}  // namespace

ParsedToml parse_toml(std::string_view text, const std::string& source) {
    ParsedToml parsed;
    std::vector<std::string> lines = lines_of(text);
    while (auto mistake = parse(joined(lines), source, parsed.root)) {
        parsed.is_whole = leave_out(lines, *mistake) && parsed.mistakes.size() < kMostMistakes;
        parsed.mistakes.push_back(std::move(*mistake));
        if (!parsed.is_whole) return parsed;
    }
    std::vector<std::string> unread;
    for (const auto& [name, node] : parsed.root)
        if (name.str().starts_with(kUnread)) unread.emplace_back(name.str());
    for (const std::string& name : unread) parsed.root.erase(name);
    return parsed;
}

}  // namespace quadrat::site
