// SPDX-License-Identifier: Apache-2.0
#include "display/options.hpp"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cmath>

#include "base/error.hpp"

namespace quadrat::display {
namespace {

struct KindName {
    Kind kind;
    std::string_view name;
};
constexpr std::array<KindName, 4> kKinds{
    {{Kind::Auto, "auto"}, {Kind::Kms, "kms"}, {Kind::Window, "window"}, {Kind::Headless, "headless"}}};

std::optional<int> whole_number(std::string_view text) {
    int value = 0;
    const char* end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || at != end || text.empty() || text.front() == '-') return std::nullopt;
    return value;
}

// Digits with at most one point; strtod would follow the locale and take "inf" and hexadecimal.
std::optional<double> plain_decimal(std::string_view text) {
    const std::size_t point = text.find('.');
    const auto whole = whole_number(text.substr(0, point));
    if (!whole) return std::nullopt;
    if (point == std::string_view::npos) return *whole;
    const std::string_view digits = text.substr(point + 1);
    const auto part = whole_number(digits);
    if (!part || digits.size() > 6) return std::nullopt;
    return *whole + *part / std::pow(10.0, static_cast<double>(digits.size()));
}

std::optional<Size> two_numbers(std::string_view text) {
    const std::size_t cross = text.find_first_of("xX");
    if (cross == std::string_view::npos) return std::nullopt;
    const auto width = whole_number(text.substr(0, cross));
    const auto height = whole_number(text.substr(cross + 1));
    if (!width || !height) return std::nullopt;
    return Size{*width, *height};
}

bool is_in_range(Size size) {
    const auto fits = [](int side) { return side >= kSmallestSide && side <= kLargestSide; };
    return fits(size.width) && fits(size.height);
}

[[noreturn]] void refuse_size(std::string_view text, std::string_view what) {
    throw base::InputError(
        fmt::format("{}: \"{}\" is not a size; write WIDTHxHEIGHT with each from {} to {}, such as "
                    "1280x720",
                    what, text, kSmallestSide, kLargestSide));
}

}  // namespace

Size size_from(std::string_view text, std::string_view what) {
    const auto size = two_numbers(text);
    if (!size || !is_in_range(*size)) refuse_size(text, what);
    return *size;
}

Kind kind_from(std::string_view text, std::string_view what) {
    for (const KindName& known : kKinds)
        if (known.name == text) return known.kind;
    throw base::InputError(fmt::format("{}: \"{}\" is not a display; it is auto, kms, window or headless", what, text));
}

std::string_view name_of(Kind kind) {
    for (const KindName& known : kKinds)
        if (known.kind == kind) return known.name;
    return "?";
}

std::optional<WantedMode> mode_from(std::string_view text, std::string_view what) {
    if (text.empty()) return std::nullopt;
    const std::size_t at = text.find('@');
    const auto size = two_numbers(text.substr(0, at));
    const auto refresh = at == std::string_view::npos ? std::optional{0.0} : plain_decimal(text.substr(at + 1));
    const bool is_refresh_right = refresh && (at == std::string_view::npos || (*refresh >= 10.0 && *refresh <= 500.0));
    if (!size || !is_in_range(*size) || !is_refresh_right)
        throw base::InputError(fmt::format(
            "{}: \"{}\" is not a mode; write WIDTHxHEIGHT or WIDTHxHEIGHT@HERTZ, such as 1920x1080@60", what, text));
    return WantedMode{*size, *refresh};
}

void check(const DisplayOptions& options) {
    mode_from(options.mode, "display mode");
    if (options.size == Size{}) return;
    if (!is_in_range(options.size))
        refuse_size(fmt::format("{}x{}", options.size.width, options.size.height), "display size");
}

}  // namespace quadrat::display
