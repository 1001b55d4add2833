#include "app/files/plot_export.h"

#include "io/support/atomic_file.h"
#include "ui/plots/convergence_plot.h"
#include "ui/plots/frame_bars.h"
#include "ui/plots/histogram_plot.h"
#include "ui/plots/motion_plot.h"
#include "ui/plots/profile_plot.h"
#include "ui/theme/active_theme.h"

#include <QBuffer>
#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>
#include <QPainter>
#include <QSvgGenerator>

namespace angiopose::app {
namespace {

constexpr double pngScale = 3.0;

QList<QWidget*> plotsOf(const QWidget& window)
{
    QList<QWidget*> plots;
    for (auto* plot : window.findChildren<ui::HistogramPlot*>()) {
        plots << plot;
    }
    for (auto* plot : window.findChildren<ui::ConvergencePlot*>()) {
        plots << plot;
    }
    for (auto* plot : window.findChildren<ui::MotionPlot*>()) {
        plots << plot;
    }
    for (auto* plot : window.findChildren<ui::ProfilePlot*>()) {
        plots << plot;
    }
    for (auto* plot : window.findChildren<ui::FrameBars*>()) {
        plots << plot;
    }
    return plots;
}

void paint(QWidget& plot, QPainter& painter)
{
    painter.fillRect(plot.rect(), ui::toQColor(ui::activePalette().panel));
    plot.render(&painter, QPoint(), QRegion(), QWidget::DrawChildren);
}

QImage imageOf(QWidget& plot)
{
    QImage image((QSizeF(plot.size()) * pngScale).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(pngScale);
    QPainter painter(&image);
    paint(plot, painter);
    painter.end();
    return image;
}

}   // namespace

QByteArray plotAsSvg(QWidget& plot)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(plot.size());
    generator.setViewBox(plot.rect());
    generator.setTitle(plot.accessibleName());
    QPainter painter(&generator);
    paint(plot, painter);
    painter.end();
    return bytes;
}

QByteArray plotAsPng(QWidget& plot)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    imageOf(plot).save(&buffer, "PNG");
    return bytes;
}

PlotExport::PlotExport(QWidget& window, ExportController& exportController, QObject* parent)
    : QObject(parent), exportController_(exportController)
{
    for (QWidget* plot : plotsOf(window)) {
        plot->setContextMenuPolicy(Qt::CustomContextMenu);
        connect(plot, &QWidget::customContextMenuRequested, this,
                [this, plot](const QPoint& position) { showMenu(*plot, position); });
    }
}

void PlotExport::showMenu(QWidget& plot, const QPoint& position)
{
    auto* menu = new QMenu(&plot);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Copy image"), this, [&plot] { QGuiApplication::clipboard()->setImage(imageOf(plot)); });
    menu->addAction(tr("Export as SVG…"), this, [this, &plot] { openDialog(plot, Format::Svg); });
    menu->addAction(tr("Export as PNG…"), this, [this, &plot] { openDialog(plot, Format::Png); });
    menu->popup(plot.mapToGlobal(position));
}

void PlotExport::openDialog(QWidget& plot, Format format)
{
    const QByteArray bytes = format == Format::Svg ? plotAsSvg(plot) : plotAsPng(plot);
    const bool isSvg = format == Format::Svg;
    exportController_.askForFile(
        {tr("Export plot"), isSvg ? tr("Vector graphics (*.svg)") : tr("PNG images (*.png)"),
         isSvg ? QStringLiteral("plot.svg") : QStringLiteral("plot.png")},
        [bytes](const QString& path) {
            return io::writeAtomically(path.toStdString(), {bytes.constData(), static_cast<std::size_t>(bytes.size())});
        });
}

}   // namespace angiopose::app
