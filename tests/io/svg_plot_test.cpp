#include "io/plot/svg_plot.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <limits>

using namespace angiopose;

namespace {

TEST(PlotScale, PutsValuesBetweenItsEnds)
{
    const io::PlotScale linear({"", 0.0, 50.0, false}, 100.0, 200.0);
    EXPECT_DOUBLE_EQ(linear.position(25.0), 150.0);
    const io::PlotScale falling({"", 0.0, 50.0, false}, 200.0, 100.0);
    EXPECT_DOUBLE_EQ(falling.position(50.0), 100.0);
    const io::PlotScale decades({"", 0.01, 100.0, true}, 0.0, 400.0);
    EXPECT_NEAR(decades.position(1.0), 200.0, 1e-9);
    EXPECT_NEAR(decades.position(0.0), 0.0, 1e-9);
    EXPECT_NEAR(decades.position(1e9), 400.0, 1e-9);
}

TEST(PlotScale, MarksRoundValues)
{
    std::vector<std::string> labels;
    for (const io::PlotTick& tick : io::PlotScale({"", 0.0, 100.0, false}, 0.0, 1.0).ticks()) {
        labels.push_back(tick.label);
    }
    EXPECT_EQ(labels, (std::vector<std::string>{"0", "20", "40", "60", "80", "100"}));
    labels.clear();
    for (const io::PlotTick& tick : io::PlotScale({"", 1e-4, 100.0, true}, 0.0, 1.0).ticks()) {
        labels.push_back(tick.label);
    }
    EXPECT_EQ(labels, (std::vector<std::string>{"1e-4", "1e-3", "0.01", "0.1", "1", "10", "100"}));
    EXPECT_TRUE(io::PlotScale({"", 1.0, 1.0, false}, 0.0, 1.0).ticks().empty());
}

TEST(SvgPlot, IsWellFormedAndEscapesNames)
{
    core::Plot plot{"id", "2° & <more>", {"x", 0.0, 10.0, false}, {"y", 0.1, 100.0, true}, {}};
    plot.series.push_back({"a<b", {{0.0, 1.0}, {5.0, std::numeric_limits<double>::infinity()}, {10.0, 50.0}}, {}});
    plot.series.push_back({"c", {{0.0, 1.0}, {10.0, 50.0}}, {{0.5, 2.0}, {40.0, 60.0}}});
    const std::string svg = io::toSvg(plot);
    EXPECT_TRUE(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
    EXPECT_NE(svg.find("2° &amp; &lt;more&gt;"), std::string::npos);
    EXPECT_NE(svg.find(">a&lt;b<"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_EQ(svg.find("–"), std::string::npos);   // an infinite coordinate would appear like this
    EXPECT_NE(svg.find("<polygon"), std::string::npos);
    // Every element is closed.
    int open = 0;
    for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
        const std::size_t end = svg.find('>', at);
        ASSERT_NE(end, std::string::npos);
        open += svg[at + 1] == '/' ? -1 : svg[end - 1] == '/' ? 0 : 1;
        EXPECT_GE(open, 0);
    }
    EXPECT_EQ(open, 0);
    EXPECT_EQ(std::count(svg.begin(), svg.end(), '"') % 2, 0);
}

}   // namespace
