#include "ui/controls/number_field.h"

#include "ui/theme/active_theme.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QSlider>
#include <QStyle>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr QChar fieldMinusSign{0x2212};

/// Returns `watched` if it is a combo box, spin box or slider, whose value the wheel would change; otherwise null.
QWidget* guardedWidget(QObject* watched)
{
    const bool holdsValue = qobject_cast<QComboBox*>(watched) || qobject_cast<QAbstractSpinBox*>(watched) ||
                            qobject_cast<QSlider*>(watched);
    return holdsValue ? static_cast<QWidget*>(watched) : nullptr;
}

}   // namespace

NumberField::NumberField(NumberFormat format, QWidget* parent) : QLineEdit(parent), format_(std::move(format))
{
    setProperty("role", "number");
    setUnit(format_.unit);
    connect(this, &QLineEdit::returnPressed, this, &NumberField::commit);
    keepTranslated(this, [this] { showValue(value_); });   // updates the decimal separator when the language changes
}

void NumberField::setUnit(const QString& unit)
{
    format_.unit = unit;
    setTextMargins(0, 0, unit.isEmpty() ? 0 : fontMetrics().horizontalAdvance(unit) + 8, 0);
    update();
}

void NumberField::showValue(std::optional<double> value)
{
    value_ = value;
    if (!(hasFocus() && isModified())) {
        setText(textOf(value));
        setCursorPosition(0);
    }
}

void NumberField::setHighlighted(bool isHighlighted)
{
    if (property("asking").toBool() != isHighlighted) {
        setProperty("asking", isHighlighted);
        style()->unpolish(this);
        style()->polish(this);
    }
}

bool NumberField::event(QEvent* event)
{
    // Reserves Up, Down and Esc for the focused field; otherwise the window's shortcuts would consume them.
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_Escape) {
            event->accept();
            return true;
        }
    }
    return QLineEdit::event(event);
}

void NumberField::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down) {
        stepBy(event->key() == Qt::Key_Up ? 1.0 : -1.0, event->modifiers());
    } else if (event->key() == Qt::Key_Escape) {
        revert();
    } else {
        QLineEdit::keyPressEvent(event);
    }
}

void NumberField::wheelEvent(QWheelEvent* event)
{
    if (!hasFocus() || isReadOnly()) {
        event->ignore();
        return;
    }
    // On some desktops, Alt and Shift turn vertical wheel steps into horizontal ones.
    const QPoint delta = event->angleDelta();
    const int notches = delta.y() != 0 ? delta.y() : delta.x();
    stepBy(notches / 120.0, event->modifiers());
    event->accept();
}

void NumberField::focusOutEvent(QFocusEvent* event)
{
    QLineEdit::focusOutEvent(event);
    commit();
}

void NumberField::paintEvent(QPaintEvent* event)
{
    QLineEdit::paintEvent(event);
    QPainter painter(this);
    painter.setPen(toQColor(activePalette().hint));
    painter.drawText(rect().adjusted(0, 0, -10, 0), Qt::AlignRight | Qt::AlignVCenter, format_.unit);
}

QSize NumberField::sizeHint() const
{
    return {110, QLineEdit::sizeHint().height()};
}

void NumberField::commit()
{
    if (!isModified()) {
        return;
    }
    const auto typed = numberFrom(text());
    setModified(false);
    if (!typed) {
        revert();
        return;
    }
    const double clamped = std::clamp(*typed, format_.min, format_.max);
    const bool isNew = !value_ || textOf(clamped) != textOf(value_);
    if (isNew) {
        value_ = clamped;
    }
    revert();
    if (isNew) {
        emit edited(clamped);
    }
}

void NumberField::revert()
{
    setText(textOf(value_));
    setModified(false);
}

void NumberField::stepBy(double steps, Qt::KeyboardModifiers modifiers)
{
    if (isModified()) {
        commit();
    }
    double factor = 1.0;
    if (modifiers & Qt::ControlModifier) {
        factor = 0.1;
    } else if (modifiers & Qt::ShiftModifier) {
        factor = 10.0;
    }
    const double finest = std::pow(10.0, -format_.decimals);
    const double step = std::max(finest, format_.step * factor);
    const double clamped = std::clamp(value_.value_or(0.0) + steps * step, format_.min, format_.max);
    if (!value_ || clamped != *value_) {
        value_ = clamped;
        revert();
        emit edited(clamped);
    }
}

QString NumberField::textOf(std::optional<double> value) const
{
    if (!value) {
        return {};
    }
    const QString digits = numberText(std::abs(*value), format_.decimals);
    const bool isZero = std::ranges::none_of(digits, [](QChar c) { return c.isDigit() && c != QLatin1Char('0'); });
    if (*value < 0.0 && !isZero) {
        return fieldMinusSign + digits;
    }
    return format_.sign == NumberSign::Always && !isZero ? QLatin1Char('+') + digits : digits;
}

WheelGuard::WheelGuard(QObject* parent) : QObject(parent)
{
    qApp->installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Polish) {
        if (QWidget* box = guardedWidget(watched); box && box->focusPolicy() == Qt::WheelFocus) {
            box->setFocusPolicy(Qt::StrongFocus);   // otherwise the wheel would give it focus
        }
    } else if (event->type() == QEvent::Wheel) {
        if (const QWidget* box = guardedWidget(watched); box && !box->hasFocus()) {
            event->ignore();   // lets the surrounding scroll area handle the event
            return true;
        }
    }
    return false;
}

}   // namespace angiopose::ui
