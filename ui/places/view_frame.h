#pragma once

#include "ui/words/spoken.h"

#include <QByteArray>
#include <QStackedWidget>
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

class ViewWindow;

/// The place in the main window of a view that can leave it for a window of its own, and comes back when that is
/// closed. While the view is away the place says so, with a way to get it back.
class ViewFrame : public QStackedWidget {
    Q_OBJECT
public:
    /// Owns the view. `title` names it in its own window.
    ViewFrame(QWidget& view, const Words& title, QWidget* parent = nullptr);

    bool isOut() const { return isOut_; }
    void setOut(bool out);
    void setFullScreen(bool on);   ///< of the view's own window; nothing happens while it is in its place

    QByteArray windowPlace() const;   ///< where its window is or was last; empty when it had none
    void setWindowPlace(const QByteArray& place) { place_ = place; }

signals:
    void outChanged(bool out);

private:
    QWidget* makeAbsence();
    void leave();
    void comeBack();

    QWidget* view_;
    QWidget* home_;
    QWidget* absence_;
    Words title_;
    ViewWindow* window_ = nullptr;
    QByteArray place_;
    bool isOut_ = false;
};

}   // namespace angiopose::ui
