#include "ui/main_window.h"

#include "ui/places/view_frame.h"
#include "ui/slices/slice_view.h"
#include "ui/views/angiogram_view.h"

#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDropEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QScrollArea>

// Input events of MainWindow: closing, dropped files, and keys that are held or repeat.

namespace angiopose::ui {
namespace {

QStringList localFiles(const QMimeData* data)
{
    QStringList paths;
    for (const QUrl& url : data->urls()) {
        if (url.isLocalFile()) {
            paths << url.toLocalFile();
        }
    }
    return paths;
}

bool acceptsText(const QWidget* widget)
{
    return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QPlainTextEdit*>(widget) ||
           qobject_cast<const QComboBox*>(widget);
}

bool isViewWindow(const QObject* object)
{
    return qobject_cast<const ViewWindow*>(object) != nullptr;
}

}   // namespace

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (closeAllowed_) {
        event->accept();
        return;
    }
    event->ignore();
    emit closeRequested();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!localFiles(event->mimeData()).isEmpty()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event)
{
    event->acceptProposedAction();
    emit filesDropped(localFiles(event->mimeData()));
}

bool MainWindow::takesKey(QObject* watched) const
{
    const auto* widget = qobject_cast<QWidget*>(watched);
    const bool isOurs = widget && (widget->window() == this || isViewWindow(widget->window()));
    return isOurs && !acceptsText(QApplication::focusWidget());
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
        case QEvent::ShortcutOverride:
        case QEvent::KeyPress:
        case QEvent::KeyRelease:
            if (takesKey(watched) && !isSliceEvent(watched, *event) && filterKey(event)) {
                return true;
            }
            break;
        case QEvent::LayoutRequest:
            if (watched == rightPanels_->widget()) {
                widenRightColumn();
            }
            break;
        case QEvent::WindowDeactivate:
            if (isHideKeyDown_ && (watched == this || isViewWindow(watched))) {
                isHideKeyDown_ = false;
                emit hideKeyToggled(false);
            }
            break;
        default:
            break;
    }
    return QMainWindow::eventFilter(watched, event);
}

/// True for key events that the tool of a slice view handles; it has priority over the image tool of the same mode.
bool MainWindow::isSliceEvent(QObject* watched, const QEvent& event)
{
    const auto* slice = qobject_cast<const SliceView*>(watched);
    return slice && event.type() != QEvent::KeyRelease && slice->wantsToolKey(static_cast<const QKeyEvent&>(event));
}

bool MainWindow::filterKey(QEvent* event)
{
    auto* key = static_cast<QKeyEvent*>(event);
    if (event->type() == QEvent::ShortcutOverride) {
        return angiogramView_->filterToolKey(*key);
    }
    if (key->key() == Qt::Key_H && key->modifiers() == Qt::NoModifier) {
        const bool pressed = event->type() == QEvent::KeyPress;
        if (!key->isAutoRepeat() && pressed != isHideKeyDown_) {
            isHideKeyDown_ = pressed;
            emit hideKeyToggled(pressed);
        }
        return true;
    }
    if (event->type() == QEvent::KeyPress && key->key() == Qt::Key_Escape) {
        emit escapePressed();
    }
    return angiogramView_->filterToolKey(*key);
}

}   // namespace angiopose::ui
