#include "ui/controls/wheel_guard.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QSlider>

namespace angiopose::ui {
namespace {

/// The box whose value a wheel over the widget would change.
QWidget* guarded(QObject* watched)
{
    const bool holdsValue = qobject_cast<QComboBox*>(watched) || qobject_cast<QAbstractSpinBox*>(watched) ||
                            qobject_cast<QSlider*>(watched);
    return holdsValue ? static_cast<QWidget*>(watched) : nullptr;
}

}   // namespace

WheelGuard::WheelGuard(QObject* parent) : QObject(parent)
{
    qApp->installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Polish) {
        if (QWidget* box = guarded(watched); box && box->focusPolicy() == Qt::WheelFocus) {
            box->setFocusPolicy(Qt::StrongFocus);   // else the wheel itself would give it the keys
        }
    } else if (event->type() == QEvent::Wheel) {
        if (const QWidget* box = guarded(watched); box && !box->hasFocus()) {
            event->ignore();   // goes on to what lies around
            return true;
        }
    }
    return false;
}

}   // namespace angiopose::ui