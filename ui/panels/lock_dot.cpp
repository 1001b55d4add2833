#include "ui/panels/lock_dot.h"

#include "ui/theme/active_theme.h"

#include <QPainter>

namespace angiopose::ui {

LockDot::LockDot(QWidget* parent) : QAbstractButton(parent)
{
    setCheckable(true);
    setCursor(Qt::PointingHandCursor);
    setFixedSize(sizeHint());
}

void LockDot::paintEvent(QPaintEvent*)
{
    const Palette& tones = activePalette();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF centre = QRectF(rect()).center();
    const QColor ring = isChecked() ? toQColor(tones.attention) : toQColor(underMouse() ? tones.text : tones.hint);
    painter.setPen(QPen(ring, 1.3));
    painter.setBrush(isChecked() ? QBrush(ring) : QBrush(Qt::NoBrush));
    painter.drawEllipse(centre, 4.5, 4.5);
    if (hasFocus()) {
        painter.setPen(QPen(toQColor(tones.accent), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(centre, 8.5, 8.5);
    }
}

}   // namespace angiopose::ui