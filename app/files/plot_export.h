#pragma once

#include "app/files/export_controller.h"

#include <QObject>

class QWidget;

namespace angiopose::app {

/// A plot as SVG text: lines and letters, sharp at any size.
QByteArray plotAsSvg(QWidget& plot);

/// A plot as PNG, three screen px to a dot.
QByteArray plotAsPng(QWidget& plot);

/// Gives the window's plots a context menu that copies them or writes them to a file.
class PlotExport : public QObject {
    Q_OBJECT
public:
    PlotExport(QWidget& window, ExportController& exporting, QObject* parent = nullptr);

    void showMenu(QWidget& plot, const QPoint& position);

private:
    enum class Format { Svg, Png };
    void ask(QWidget& plot, Format format);

    ExportController& exporting_;
};

}   // namespace angiopose::app