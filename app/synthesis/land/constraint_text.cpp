// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/constraint_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "base/error.hpp"

namespace quadrat::synthesis::land {
namespace {

// One line of the text, as words; errors name it.
class Words {
  public:
    Words(std::string_view line, std::string_view source, int number)
        : left_(line.substr(0, line.find('#'))), source_(source), number_(number) {}

    bool are_done() {
        left_.remove_prefix(std::min(left_.find_first_not_of(" \t\r"), left_.size()));
        return left_.empty();
    }
    std::string_view next(std::string_view wanted) {
        if (are_done()) fail(fmt::format("{} is missing", wanted));
        const std::string_view word = left_.substr(0, left_.find_first_of(" \t\r"));
        left_.remove_prefix(word.size());
        return word;
    }
    FixedPoint point() {
        FixedPoint p;
        p.column = whole("the column");
        p.row = whole("the row");
        p.height = height();
        return p;
    }
    [[noreturn]] void fail(const std::string& what) const {
        throw base::InputError(fmt::format("{}:{}: {}", source_, number_, what));
    }

  private:
    // As it may stand in a message.
    static std::string brief(std::string_view word) {
        std::string text(word.substr(0, 24));
        for (char& c : text)
            if (c < ' ' || c > '~') c = '?';
        return word.size() > 24 ? text + "..." : text;
    }
    int whole(std::string_view what) {
        const std::string_view word = next(what);
        int value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || end != word.data() + word.size())
            fail(fmt::format("{} is {}; a whole number of samples is right", what, brief(word)));
        return value;
    }
    float height() {
        const std::string_view word = next("the height");
        float value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
            fail(fmt::format("the height is {}; a number is right, as 0.75", brief(word)));
        return value;
    }

    std::string_view left_;
    std::string_view source_;
    int number_;
};

template <typename Take>
void for_lines(std::string_view text, std::string_view source, const Take& take) {
    for (int number = 1; !text.empty(); ++number) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        Words words(line, source, number);
        if (!words.are_done()) take(words);
    }
}

}  // namespace

std::vector<FixedPoint> fixed_points_from(std::string_view text, std::string_view source) {
    std::vector<FixedPoint> points;
    for_lines(text, source, [&](Words& words) {
        if (points.size() == kMostFixedPoints)
            words.fail(fmt::format("more than {} fixed points; no more can be met", kMostFixedPoints));
        points.push_back(words.point());
        if (!words.are_done()) words.fail("a fixed point is three numbers: column row height");
    });
    return points;
}

std::vector<Line> lines_from(std::string_view text, std::string_view source) {
    std::vector<Line> lines;
    std::size_t corners = 0;
    for_lines(text, source, [&](Words& words) {
        const std::string_view kind = words.next("ridge or river");
        if (kind != "ridge" && kind != "river") words.fail("a line begins with ridge or river");
        Line line;
        line.kind = kind == "ridge" ? Line::Kind::Ridge : Line::Kind::River;
        while (!words.are_done()) {
            if (++corners > kMostCorners)
                words.fail(fmt::format("more than {} corners of lines; no more can be met", kMostCorners));
            line.corners.push_back(words.point());
        }
        if (line.corners.size() < 2)
            words.fail("a line has two or more corners, three numbers each: column row height");
        lines.push_back(std::move(line));
    });
    return lines;
}

}  // namespace quadrat::synthesis::land
