#pragma once

#include "ui/words/spoken.h"

#include <QWidget>

namespace angiopose::ui {

/// A window of its own for a view that left the main window; on another screen where there is one. The main window's
/// keys act in it too. Closing it only asks for the view to go back.
class ViewWindow : public QWidget {
    Q_OBJECT
public:
    ViewWindow(QWidget* mainWindow, const Words& title);

    void hold(QWidget& view);
    void goToAnotherScreen();   ///< stays where it is when there is only one

signals:
    void closeRequested();

protected:
    void closeEvent(QCloseEvent* event) override;
};

}   // namespace angiopose::ui