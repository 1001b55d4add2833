#include "ui/places/view_frame.h"

#include "ui/controls/screen_room.h"
#include "ui/controls/section.h"
#include "ui/words/spoken.h"

#include <QCloseEvent>
#include <QGuiApplication>
#include <QPushButton>
#include <QScreen>
#include <QTimer>
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

ViewFrame::ViewFrame(QWidget& view, const Words& title, QWidget* parent)
    : QStackedWidget(parent), view_(&view), home_(new QWidget), absence_(makeAbsence()), title_(title)
{
    auto* layout = new QVBoxLayout(home_);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(view_);
    addWidget(home_);
    addWidget(absence_);
}

QWidget* ViewFrame::makeAbsence()
{
    auto* absence = new QWidget;
    auto* layout = new QVBoxLayout(absence);
    auto* words = withText(roleLabel("hint"), [] { return tr("Shown in a separate window"); });
    words->setAlignment(Qt::AlignCenter);
    auto* back = withText(new QPushButton, [] { return tr("Bring back"); });
    back->setProperty("role", "link");
    connect(back, &QPushButton::clicked, this, [this] { setOut(false); });
    layout->addStretch(1);
    layout->addWidget(words);
    layout->addWidget(back, 0, Qt::AlignHCenter);
    layout->addStretch(1);
    return absence;
}

void ViewFrame::setOut(bool out)
{
    if (out == isOut_) {
        return;
    }
    isOut_ = out;
    if (out) {
        leave();
    } else {
        comeBack();
    }
    view_->setFocus(Qt::OtherFocusReason);
    emit outChanged(out);
}

void ViewFrame::leave()
{
    window_ = new ViewWindow(window(), title_);
    connect(window_, &ViewWindow::closeRequested, this, [this] { setOut(false); });
    window_->hold(*view_);
    if (!window_->restoreGeometry(place_)) {
        window_->goToAnotherScreen();
    }
    setCurrentWidget(absence_);
    const auto show = [own = window_] {
        own->show();
        own->activateWindow();
    };
    if (window()->isVisible()) {
        show();
    } else {
        QTimer::singleShot(0, window_, show);   // deferred until the main window is visible
    }
}

void ViewFrame::comeBack()
{
    place_ = window_->saveGeometry();
    home_->layout()->addWidget(view_);
    setCurrentWidget(home_);
    view_->show();
    window_->hide();
    window_->deleteLater();   // deferred, since this may run inside the close event of `window_`
    window_ = nullptr;
    window()->activateWindow();   // some desktops do not return the focus to the main window
}

void ViewFrame::setFullScreen(bool on)
{
    if (window_) {
        window_->setWindowState(window_->windowState().setFlag(Qt::WindowFullScreen, on));
    }
}

QByteArray ViewFrame::windowPlace() const
{
    return window_ ? window_->saveGeometry() : place_;
}

}   // namespace angiopose::ui
