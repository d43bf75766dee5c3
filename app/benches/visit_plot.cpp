// SPDX-License-Identifier: Apache-2.0
#include "benches/visit_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/markup.hpp"

namespace quadrat::benches {
namespace {

constexpr double kWidth = 1200;
constexpr double kHeight = 420;
constexpr double kLeft = 60;
constexpr double kRight = 60;
constexpr double kTop = 30;
constexpr double kBottom = 50;

double seconds(base::Instant span) { return std::chrono::duration<double>(span).count(); }

struct Scale {
    double last_s;
    double most_ms;
    double x(double at_s) const { return kLeft + (kWidth - kLeft - kRight) * at_s / last_s; }
    double y(double ms) const { return kHeight - kBottom - (kHeight - kTop - kBottom) * std::min(ms / most_ms, 1.0); }
    double y_of_level(double level) const {
        constexpr double kLeast = -5;  // powers of two
        return y(most_ms * std::clamp(1 - std::log2(level) / kLeast, 0.0, 1.0));
    }
};

std::string bars(const std::vector<FrameSeen>& frames, const Scale& scale) {
    std::string svg;
    for (std::size_t i = 0; i < frames.size();) {
        std::size_t end = i;
        while (end < frames.size() && frames[end].is_growing == frames[i].is_growing) ++end;
        if (frames[i].is_growing)
            svg += fmt::format(R"(<rect class="growing" x="{:.1f}" y="{}" width="{:.1f}" height="{}" fill="#e8f0e0"/>)",
                               scale.x(seconds(frames[i].at)), kTop,
                               std::max(0.5, scale.x(seconds(frames[end - 1].at)) - scale.x(seconds(frames[i].at))),
                               kHeight - kTop - kBottom) +
                   "\n";
        i = end;
    }
    return svg;
}

template <typename Value>
std::string line(const std::vector<FrameSeen>& frames, const Scale& scale, const char* look, Value value) {
    std::string points;
    for (const FrameSeen& frame : frames)
        points += fmt::format("{:.1f},{:.1f} ", scale.x(seconds(frame.at)), value(frame));
    return fmt::format(R"(<polyline fill="none" {} stroke-width="1" points="{}"/>)", look, points) + "\n";
}

std::string marks(const std::vector<kiosk::RunRecord::Decision>& decisions, const Scale& scale) {
    std::string svg;
    for (const kiosk::RunRecord::Decision& decision : decisions)
        svg += fmt::format(R"(<circle cx="{:.1f}" cy="{}" r="4" fill="#c05010"><title>{:.1f} s: {}</title></circle>)",
                           scale.x(seconds(decision.at)), kTop, seconds(decision.at), base::escaped(decision.why)) +
               "\n";
    return svg;
}

}  // namespace

std::string plot_of(const std::vector<FrameSeen>& frames, const std::vector<kiosk::RunRecord::Decision>& decisions) {
    if (frames.empty()) return R"(<svg xmlns="http://www.w3.org/2000/svg"/>)";
    const double deadline_ms = 1e3 * seconds(std::ranges::max(frames, {}, &FrameSeen::deadline).deadline);
    const Scale scale{std::max(seconds(frames.back().at), 1.0), 4 * deadline_ms};
    std::string svg = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {} {}" font-family="sans-serif" font-size="12" fill="currentColor">)",
        kWidth, kHeight);
    svg +=
        "\n"
        R"(<rect class="paper" width="100%" height="100%" fill="white"/>)"
        "\n" +
        bars(frames, scale);
    for (double ms = 0; ms <= scale.most_ms + 1e-9; ms += deadline_ms)
        svg += fmt::format(R"(<text x="{}" y="{:.1f}" text-anchor="end">{:.0f} ms</text>)", kLeft - 6, scale.y(ms) + 4,
                           ms) +
               "\n";
    for (int step = 0; step <= 5; ++step)
        svg += fmt::format(R"(<text x="{}" y="{:.1f}" fill="#c05010">{:.3g}</text>)", kWidth - kRight + 6,
                           scale.y_of_level(std::exp2(-step)) + 4, std::exp2(-step)) +
               "\n";
    const double every_s = scale.last_s > 300 ? 60 : scale.last_s > 60 ? 10 : 5;
    for (double at_s = 0; at_s <= scale.last_s; at_s += every_s)
        svg += fmt::format(R"(<text x="{:.1f}" y="{}" text-anchor="middle">{:.0f} s</text>)", scale.x(at_s),
                           kHeight - kBottom + 18, at_s) +
               "\n";
    for (std::size_t i = 1; i < frames.size(); ++i)
        if (frames[i].act != frames[i - 1].act)
            svg += fmt::format(R"(<line x1="{0:.1f}" x2="{0:.1f}" y1="{1}" y2="{2}" stroke="#80a060"/>)",
                               scale.x(seconds(frames[i].at)), kTop, kHeight - kBottom) +
                   "\n";
    svg += line(frames, scale, R"(class="took" stroke="#3060a0")",
                [&](const FrameSeen& f) { return scale.y(1e3 * seconds(f.took)); });
    svg += line(frames, scale, R"(stroke="#909090")",
                [&](const FrameSeen& f) { return scale.y(1e3 * seconds(f.deadline)); });
    svg += line(frames, scale, R"(stroke="#c05010")", [&](const FrameSeen& f) { return scale.y_of_level(f.level); });
    svg += marks(decisions, scale);
    svg += fmt::format(
        R"(<text x="{}" y="18">frame times (blue), their deadline (grey), level of detail (orange, right; a dot: why it changed), growing (shaded), arrivals (green)</text>)",
        kLeft);
    return svg + "\n</svg>\n";
}

}  // namespace quadrat::benches
