#include "app/files/plot_export.h"

#include "ui/plots/histogram_plot.h"

#include <gtest/gtest.h>
#include <QImage>
#include <QSvgRenderer>

namespace app {
namespace {

/// Drawn shapes, whichever element they became.
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
    EXPECT_FALSE(svg.contains("<image"));   // a raster in disguise
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

}   // namespace
}   // namespace app
