#include "ui/plots/frame_bars.h"

#include "ui/theme/active_theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace ui {

FrameBars::FrameBars(QWidget* parent) : QWidget(parent)
{
    setMinimumHeight(36);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(tr("Frames by opacification"));
}

void FrameBars::showFrames(const std::vector<double>& opacification, int suggested)
{
    opacification_ = opacification;
    suggested_ = suggested;
    setCursor(opacification_.size() > 1 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    update();
}

void FrameBars::showCurrent(int frame)
{
    current_ = frame;
    update();
}

void FrameBars::paintEvent(QPaintEvent*)
{
    if (opacification_.empty()) {
        return;
    }
    const Palette& tones = activePalette();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double slot = width() / static_cast<double>(opacification_.size());
    const double gap = slot > 12.0 ? 3.0 : slot > 4.0 ? 1.0 : 0.0;
    for (std::size_t i = 0; i < opacification_.size(); ++i) {
        const QRectF cell(slot * static_cast<double>(i) + 1.0, 1.0, std::max(1.0, slot - gap - 1.0), height() - 2.0);
        painter.fillRect(cell, toQColor(tones.field));
        const double filled = std::clamp(opacification_[i], 0.0, 1.0) * cell.height();
        painter.fillRect(QRectF(cell.left(), cell.bottom() - filled, cell.width(), filled),
                         toQColor(tones.accent, static_cast<int>(i) == current_ ? 0.55 : 0.28));
        if (static_cast<int>(i) == suggested_ && slot > 10.0) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(toQColor(tones.fine));
            painter.drawEllipse(QPointF(cell.center().x(), cell.top() + 6.0), 2.5, 2.5);
            painter.setBrush(Qt::NoBrush);
        }
        if (static_cast<int>(i) == current_) {
            painter.setPen(QPen(toQColor(tones.accent), hasFocus() ? 2.0 : 1.5));
            painter.drawRoundedRect(cell, 2.0, 2.0);
        }
    }
}

int FrameBars::frameAt(double x) const
{
    const int count = static_cast<int>(opacification_.size());
    return std::clamp(static_cast<int>(x / std::max(1, width()) * count), 0, count - 1);
}

void FrameBars::request(int frame)
{
    if (!opacification_.empty() && frame != current_) {
        emit frameRequested(std::clamp(frame, 0, static_cast<int>(opacification_.size()) - 1));
    }
}

void FrameBars::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && !opacification_.empty()) {
        request(frameAt(event->position().x()));
    }
}

void FrameBars::mouseMoveEvent(QMouseEvent* event)
{
    if (opacification_.empty()) {
        return;
    }
    const int frame = frameAt(event->position().x());
    setToolTip(frame == suggested_ ? tr("Frame %1, the fullest").arg(frame) : tr("Frame %1").arg(frame));
    if (event->buttons() & Qt::LeftButton) {
        request(frame);
    }
}

void FrameBars::keyPressEvent(QKeyEvent* event)
{
    const int last = static_cast<int>(opacification_.size()) - 1;
    switch (event->key()) {
        case Qt::Key_Left:
            return request(std::max(0, current_ - 1));
        case Qt::Key_Right:
            return request(std::min(last, current_ + 1));
        case Qt::Key_Home:
            return request(0);
        case Qt::Key_End:
            return request(last);
        default:
            QWidget::keyPressEvent(event);
    }
}

}   // namespace ui
