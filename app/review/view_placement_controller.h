#pragma once

#include "ui/main_window.h"

#include <QObject>

namespace angiopose::app {

/// Manages where views appear: alone in the main window, or in a separate window (on another screen if there is one);
/// also folds the side panels.
class ViewPlacementController : public QObject {
    Q_OBJECT
public:
    explicit ViewPlacementController(ui::MainWindow& window, QObject* parent = nullptr);

private:
    void connectSingleView(ui::Command command, ui::MovableView view);
    void connectWindow(ui::Command command, ui::MovableView view);
    void connectSlices();
    void connectCollapsing(ui::Command command, ui::ColumnSide side);
    void setSingleView(ui::MovableView view, bool on);

    ui::MainWindow& window_;
};

}   // namespace angiopose::app
