#include "ui/panels/lock_button.h"

#include "ui/theme/active_theme.h"

#include <QPainter>
#include <QPainterPath>

namespace angiopose::ui {

LockButton::LockButton(QWidget* parent) : QAbstractButton(parent)
{
    setCheckable(true);
    setCursor(Qt::PointingHandCursor);
    setFixedSize(sizeHint());
}

void LockButton::paintEvent(QPaintEvent*)
{
    const Palette& colors = activePalette();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF center = QRectF(rect()).center();
    const QColor ring = isChecked() ? toQColor(colors.attention) : toQColor(underMouse() ? colors.text : colors.hint);
    painter.setPen(QPen(ring, 1.3));
    painter.setBrush(isChecked() ? QBrush(ring) : QBrush(Qt::NoBrush));
    painter.drawRoundedRect(QRectF(center.x() - 4.5, center.y() - 0.5, 9.0, 6.5), 1.0, 1.0);
    painter.setBrush(Qt::NoBrush);
    const double lift = isChecked() ? 0.0 : 2.0;   // the shackle of an open padlock is raised
    const QRectF shackle(center.x() - 3.0, center.y() - 5.5 - lift, 6.0, 6.0);
    QPainterPath path(QPointF(shackle.left(), center.y() - 0.5));
    path.lineTo(shackle.left(), shackle.center().y());
    path.arcTo(shackle, 180.0, -180.0);
    path.lineTo(shackle.right(), center.y() - 0.5 - lift);
    painter.drawPath(path);
    if (hasFocus()) {
        painter.setPen(QPen(toQColor(colors.accent), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(center, 8.5, 8.5);
    }
}

}   // namespace angiopose::ui
