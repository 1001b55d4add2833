#include "ui/places/view_window.h"

#include "ui/controls/screen_room.h"

#include <QCloseEvent>
#include <QGuiApplication>
#include <QScreen>
#include <QVBoxLayout>

namespace angiopose::ui {
namespace {

constexpr QSize usualSize(900, 760);

}   // namespace

ViewWindow::ViewWindow(QWidget* mainWindow, const Words& title) : QWidget(mainWindow, Qt::Window)
{
    speak(this, [this, title] { setWindowTitle(title()); });
    setProperty("role", "canvas");
    setAttribute(Qt::WA_StyledBackground);
    addActions(mainWindow->actions());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    resizeOnScreen(*this, usualSize);
}

void ViewWindow::hold(QWidget& view)
{
    layout()->addWidget(&view);
    view.show();
}

void ViewWindow::goToAnotherScreen()
{
    const QScreen* mine = parentWidget()->screen();
    for (const QScreen* screen : QGuiApplication::screens()) {
        if (screen != mine) {
            setGeometry(screen->availableGeometry());
            return;
        }
    }
}

void ViewWindow::closeEvent(QCloseEvent* event)
{
    event->ignore();
    emit closeRequested();
}

}   // namespace angiopose::ui