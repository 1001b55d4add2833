#include "app/files/plot_export.h"

#include "ui/plots/convergence_plot.h"
#include "ui/plots/histogram_plot.h"

#include <gtest/gtest.h>
#include <QImage>
#include <QSvgRenderer>

#include <cmath>

namespace angiopose::app {
namespace {

/// Number of drawn shapes, of any SVG element type.
qsizetype shapesIn(const QByteArray& svg)
{
    return svg.count("<rect") + svg.count("<path") + svg.count("<poly");
}

TEST(PlotExport, WritesLinesNotPixelsAsSvg)
{
    ui::HistogramPlot plot;
    plot.resize(220, 92);
    const QByteArray empty = plotAsSvg(plot);
    plot.showValues({0.1, 0.2, 0.2, 0.9, 1.4, 5.0}, 2.0);
    const QByteArray svg = plotAsSvg(plot);

    QSvgRenderer renderer(svg);
    EXPECT_TRUE(renderer.isValid());
    EXPECT_EQ(renderer.viewBox(), QRect(0, 0, 220, 92));
    EXPECT_FALSE(svg.contains("<image"));   // would be a raster image instead of vectors
    EXPECT_TRUE(svg.contains("above 2.0"));
    EXPECT_GT(shapesIn(svg), shapesIn(empty) + 3);
}

TEST(PlotExport, WritesThreeDotsPerPixelAsPng)
{
    ui::HistogramPlot plot;
    plot.resize(220, 92);
    plot.showValues({0.1, 0.2, 5.0}, 2.0);
    QImage image;
    ASSERT_TRUE(image.loadFromData(plotAsPng(plot), "PNG"));
    EXPECT_EQ(image.size(), QSize(660, 276));
}

TEST(PlotExport, ShowsDistanceAndStepOfARunWithTheirUnits)
{
    ui::ConvergencePlot plot;
    plot.resize(300, 148);
    const QByteArray empty = plotAsSvg(plot);
    std::vector<core::IterationReport> history(12);
    for (std::size_t i = 0; i < history.size(); ++i) {
        history[i].iteration = static_cast<int>(i) + 1;
        history[i].medianDistancePx = 30.0 / static_cast<double>(i + 1);
        history[i].stepMm = i % 3 == 2 ? 0.0 : 8.0 * std::pow(0.4, i);   // some steps do not move the pose
    }
    plot.showHistory(history);
    const QByteArray svg = plotAsSvg(plot);

    EXPECT_FALSE(svg.contains("<image"));
    for (const char* words : {"median distance", "vessel shift per step", "10 px", "1 mm", "step 1", ">12<"}) {
        EXPECT_TRUE(svg.contains(words)) << words;
    }
    EXPECT_FALSE(empty.contains("px"));
    EXPECT_EQ(svg.count("stroke-dasharray"), 2)
        << "the step's line and its sample are dashed: distinguishable without color";
}

TEST(LogLane, SpansWhatCanBeSeenAndNoMore)
{
    const std::vector<double> still{2.0, 2.0}, deep{5.0, 0.0, 1e-9}, none{0.0, 0.0};
    EXPECT_NEAR(ui::logRangeOf(still).top - ui::logRangeOf(still).bottom, 1.0, 1e-9);
    EXPECT_GT(ui::logRangeOf(deep).top, std::log10(5.0));
    EXPECT_NEAR(ui::logRangeOf(deep).top - ui::logRangeOf(deep).bottom, 4.0, 1e-9);
    EXPECT_LT(ui::logRangeOf(none).bottom, ui::logRangeOf(none).top);
}

}   // namespace
}   // namespace angiopose::app
