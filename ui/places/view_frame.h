#pragma once

#include "ui/words/retranslation.h"

#include <QByteArray>
#include <QStackedWidget>
#include <QWidget>

namespace angiopose::ui {

/// Window of a popped-out view, on another screen if available. The shortcuts of the main window also work here.
/// Closing the window only emits `closeRequested`, on which the owner docks the view.
class ViewWindow : public QWidget {
    Q_OBJECT
public:
    ViewWindow(QWidget* mainWindow, const LocalizedText& title);

    void setView(QWidget& view);
    void goToAnotherScreen();   ///< has no effect if there is only one screen

signals:
    void closeRequested();

protected:
    void closeEvent(QCloseEvent* event) override;
};

class ViewWindow;

/// Frame that docks a view in the main window. The view can pop out into a window and returns when that window is
/// closed; meanwhile a placeholder offers to bring the view back.
class ViewFrame : public QStackedWidget {
    Q_OBJECT
public:
    /// Takes ownership of the view; `title` is the title of the popped-out window.
    ViewFrame(QWidget& view, const LocalizedText& title, QWidget* parent = nullptr);

    bool isPoppedOut() const { return isPoppedOut_; }
    void setPoppedOut(bool out);
    void setFullScreen(bool on);   ///< applies to the popped-out window; has no effect while the view is docked

    QByteArray savedGeometry() const;   ///< last geometry of the window; empty if the view was never popped out
    void setSavedGeometry(const QByteArray& place) { savedGeometry_ = place; }

signals:
    void poppedOutChanged(bool out);

private:
    QWidget* makePlaceholder();
    void popOut();
    void dock();

    QWidget* view_;
    QWidget* dockedPage_;
    QWidget* placeholder_;
    LocalizedText title_;
    ViewWindow* window_ = nullptr;
    QByteArray savedGeometry_;
    bool isPoppedOut_ = false;
};

}   // namespace angiopose::ui
