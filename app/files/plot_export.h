#pragma once

#include "app/files/export_controller.h"

#include <QObject>

class QWidget;

namespace angiopose::app {

/// Returns the plot as SVG with vector lines and text.
QByteArray plotAsSvg(QWidget& plot);

/// Returns the plot as PNG at three times the screen resolution.
QByteArray plotAsPng(QWidget& plot);

/// Adds a context menu to the window's plots that copies a plot or writes it to a file.
class PlotExport : public QObject {
    Q_OBJECT
public:
    PlotExport(QWidget& window, ExportController& exportController, QObject* parent = nullptr);

    void showMenu(QWidget& plot, const QPoint& position);

private:
    enum class Format { Svg, Png };
    void openDialog(QWidget& plot, Format format);

    ExportController& exportController_;
};

}   // namespace angiopose::app
