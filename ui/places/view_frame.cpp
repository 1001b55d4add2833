#include "ui/places/view_frame.h"

#include "ui/controls/screen_fit.h"
#include "ui/controls/section.h"
#include "ui/words/retranslation.h"

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

ViewWindow::ViewWindow(QWidget* mainWindow, const LocalizedText& title) : QWidget(mainWindow, Qt::Window)
{
    keepTranslated(this, [this, title] { setWindowTitle(title()); });
    setProperty("role", "canvas");
    setAttribute(Qt::WA_StyledBackground);
    addActions(mainWindow->actions());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    resizeWithinScreen(*this, usualSize);
}

void ViewWindow::setView(QWidget& view)
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

ViewFrame::ViewFrame(QWidget& view, const LocalizedText& title, QWidget* parent)
    : QStackedWidget(parent), view_(&view), dockedPage_(new QWidget), placeholder_(makePlaceholder()), title_(title)
{
    auto* layout = new QVBoxLayout(dockedPage_);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(view_);
    addWidget(dockedPage_);
    addWidget(placeholder_);
}

QWidget* ViewFrame::makePlaceholder()
{
    auto* absence = new QWidget;
    auto* layout = new QVBoxLayout(absence);
    auto* text = withText(roleLabel("hint"), [] { return tr("Shown in a separate window"); });
    text->setAlignment(Qt::AlignCenter);
    auto* back = withText(new QPushButton, [] { return tr("Bring back"); });
    back->setProperty("role", "link");
    connect(back, &QPushButton::clicked, this, [this] { setPoppedOut(false); });
    layout->addStretch(1);
    layout->addWidget(text);
    layout->addWidget(back, 0, Qt::AlignHCenter);
    layout->addStretch(1);
    return absence;
}

void ViewFrame::setPoppedOut(bool out)
{
    if (out == isPoppedOut_) {
        return;
    }
    isPoppedOut_ = out;
    if (out) {
        popOut();
    } else {
        dock();
    }
    view_->setFocus(Qt::OtherFocusReason);
    emit poppedOutChanged(out);
}

void ViewFrame::popOut()
{
    window_ = new ViewWindow(window(), title_);
    connect(window_, &ViewWindow::closeRequested, this, [this] { setPoppedOut(false); });
    window_->setView(*view_);
    if (!window_->restoreGeometry(savedGeometry_)) {
        window_->goToAnotherScreen();
    }
    setCurrentWidget(placeholder_);
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

void ViewFrame::dock()
{
    savedGeometry_ = window_->saveGeometry();
    dockedPage_->layout()->addWidget(view_);
    setCurrentWidget(dockedPage_);
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

QByteArray ViewFrame::savedGeometry() const
{
    return window_ ? window_->saveGeometry() : savedGeometry_;
}

}   // namespace angiopose::ui
