// SPDX-License-Identifier: Apache-2.0
#include "benches/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benches/rivals.hpp"
#include "benches/visit_plot.hpp"

namespace quadrat::benches {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::size_t count_of(const std::string& text, const std::string& what) {
    std::size_t count = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
    return count;
}

Report report_of(std::vector<machine::Measurement> figures) {
    Report report{"A processor, 4 cores, 8.0 GB", "1.2.3", "2026-01-31 12:00 UTC", {}, {}, {}, std::nullopt};
    for (machine::Measurement& figure : figures) report.results.push_back(std::move(figure));
    return report;
}

std::string plot_of_a_visit() {
    std::vector<FrameSeen> frames;
    for (int i = 0; i < 60; ++i) frames.push_back({i * 16ms, 16ms, 16ms, 16ms});
    return plot_of(frames, {{500ms, "a < b & c"}});
}

TEST(Report, HoldsEachFigureWithItsUnitAndWhatOthersNeed) {
    const std::string html = html_of(report_of(
        {{"frame.median_ms", 12.345, "ms", 3}, {"detail.chain_ms", 60, "ms", 1, "meshoptimizer 126-134; CGAL 2046"}}));
    for (const char* text :
         {"frame.median_ms", "12.35", "<td class=\"n\">3</td>", "detail.chain_ms", "meshoptimizer 126-134", "CGAL 2046",
          "A processor, 4 cores, 8.0 GB", "quadrat 1.2.3", "2026-01-31 12:00 UTC", "nothing was drawn"})
        EXPECT_THAT(html, HasSubstr(text));
}

TEST(Report, HasOneTableForFiguresWhoseNamesBeginAlike) {
    const std::string html = html_of(
        report_of({{"start.first_ms", 1, "ms"}, {"frame.median_ms", 2, "ms"}, {"start.fresh_first_ms", 3, "ms"}}));
    EXPECT_EQ(count_of(html, "<table"), 2U);
    EXPECT_LT(html.find("start.fresh_first_ms"), html.find("frame.median_ms"));
}

TEST(Report, EscapesWhateverItIsGiven) {
    Report report = report_of({{"odd.<b>&", 1, "a<b&c", 1, "\"peer\" <2>"}});
    report.machine = "<machine & co>";
    report.results.gpu = "<gpu>";
    report.settings = {{"--size <&>", {"<group>"}}};
    report.shaders = ShaderTable{"<mesa>", {{"<v>", "<f>", "fragment", "<chip>", 1, 4, 0, 0, 10}}};
    const std::string html = html_of(report);
    for (const char* raw :
         {"<b>&", "a<b&c", "\"peer\"", "<machine", "<gpu>", "<&>", "<group>", "<mesa>", "<v>", "<f>", "<chip>"})
        EXPECT_THAT(html, Not(HasSubstr(raw)));
    for (const char* safe : {"odd.&lt;b&gt;&amp;", "a&lt;b&amp;c", "&quot;peer&quot; &lt;2&gt;", "&lt;machine &amp; co",
                             "&lt;gpu&gt;", "&lt;mesa&gt;", "V3D &lt;chip&gt;"})
        EXPECT_THAT(html, HasSubstr(safe));
}

TEST(Report, ShowsThePlotOfAVisitOnceAndRefersToNothingOutside) {
    Report report = report_of({{"frame.median_ms", 2, "ms"}, {"visit.level", 1, ""}, {"visit.generations", 3, ""}});
    EXPECT_THAT(html_of(report), Not(HasSubstr("http")));
    report.results.visit_svg = plot_of_a_visit();
    const std::string html = html_of(report);
    EXPECT_EQ(count_of(html, report.results.visit_svg), 1U);
    EXPECT_EQ(count_of(html, "http"), count_of(html, "xmlns=\"http://www.w3.org/2000/svg\""));
    EXPECT_EQ(count_of(html, "http"), 1U);
    for (const char* outside : {"<script", "<link", "<img", "src=", "href=", "url(", "@import"})
        EXPECT_THAT(html, Not(HasSubstr(outside)));
}

TEST(Report, TellsTheSettingsThatTheGroupsHeed) {
    Options how;
    how.hz = 60;
    how.triangles = 60000;
    const auto options_of = [&](const std::vector<std::string>& measured) {
        std::vector<std::string> options;
        for (const Setting& setting : settings_of(how, measured)) options.push_back(setting.option);
        return options;
    };
    EXPECT_THAT(options_of({"generation", "land"}), testing::IsEmpty());
    EXPECT_THAT(options_of({"visit"}), ElementsAre("--size 1280x720", "--alpha 1", "--minutes 2", "--hz 60"));
    EXPECT_THAT(options_of({"fidelity"}), ElementsAre("--size 1280x720", "--alpha 1", "--triangles 60000"));
    how.profile = "pi4";
    EXPECT_THAT(options_of({"detail"}), ElementsAre("--alpha 1", "--profile pi4", "--triangles 60000"));
}

TEST(Rivals, HaveAFigureWhereTheirTextHasASingleOne) {
    const auto figure_of = [](const char* text) { return rivals_of(text).front().figure; };
    EXPECT_EQ(figure_of("ez-tree 16.5 (22.6k triangles)")->least, 16.5);
    EXPECT_EQ(figure_of("meshoptimizer 126-134")->least, 126);
    EXPECT_EQ(figure_of("meshoptimizer 126-134")->most, 134);
    EXPECT_EQ(figure_of("paper 20000 and more")->most, 20000);
    EXPECT_FALSE(figure_of("paper: minutes"));
    EXPECT_FALSE(figure_of("VTK, the field given: flying edges 25, marching cubes 77"));
    EXPECT_EQ(rivals_of("paper: minutes; ez-tree 1.4; proctree 16-35").size(), 3U);
    EXPECT_TRUE(rivals_of("").empty());
}

}  // namespace
}  // namespace quadrat::benches
