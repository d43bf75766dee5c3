// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/text.hpp"

#include <algorithm>
#include <charconv>

namespace quadrat::firmware_io {
namespace {

struct Unit {
    std::string_view name;
    std::int64_t ns;
};
constexpr std::array kUnits{Unit{"us", 1'000}, Unit{"ms", 1'000'000}, Unit{"s", 1'000'000'000},
                            Unit{"min", 60'000'000'000}, Unit{"h", 3'600'000'000'000}};
constexpr std::int64_t kLongest_ns = 1000 * kUnits.back().ns;
constexpr std::size_t kMostDigits = 7;  // before and after the point: no product leaves 64 bits

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view take_digits(std::string_view& text) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
    const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(digits.size());
    return digits;
}

}  // namespace

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> pieces;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        pieces.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return pieces;
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    while (!(line = trimmed(line)).empty()) {
        const auto end = std::find_if(line.begin(), line.end(), is_blank);
        words.push_back(line.substr(0, static_cast<std::size_t>(end - line.begin())));
        line.remove_prefix(words.back().size());
    }
    return words;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

std::optional<std::uint32_t> parse_unsigned(std::string_view text, int base) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<Instant> parse_duration(std::string_view text) {
    const std::string_view whole = take_digits(text);
    std::string_view fraction;
    if (!text.empty() && text.front() == '.') {
        text.remove_prefix(1);
        fraction = take_digits(text);
        if (fraction.empty()) return std::nullopt;
    }
    if (whole.empty() || whole.size() > kMostDigits || fraction.size() > kMostDigits) return std::nullopt;
    const auto unit = std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& u) { return u.name == text; });
    if (unit == kUnits.end()) return std::nullopt;
    const std::int64_t whole_units = *parse_unsigned(whole);
    if (whole_units > kLongest_ns / unit->ns) return std::nullopt;
    std::int64_t ns = whole_units * unit->ns;
    std::int64_t place_ns = unit->ns;
    for (const char digit : fraction) ns += (digit - '0') * (place_ns /= 10);
    return Instant{ns};
}

std::string one_word(std::string_view text) {
    std::string word;
    for (const char c : text) word += c > ' ' && c <= '~' && c != '#' ? c : '_';
    return word;
}

std::string quoted(std::string_view text) {
    constexpr std::size_t kMost = 40;
    std::string out = "\"";
    for (const char c : text.substr(0, kMost)) out += c >= ' ' && c <= '~' ? c : '?';
    out += text.size() > kMost ? "…\"" : "\"";
    return out;
}

}  // namespace quadrat::firmware_io
