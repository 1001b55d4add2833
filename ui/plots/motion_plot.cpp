#include "ui/plots/motion_plot.h"

#include "ui/theme/active_theme.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr int motionLabelHeight = 18;
constexpr double dotPx = 2.2;
constexpr double minAxisMm = 0.5;   // minimum range of the y axis, to keep noise from looking like motion

}   // namespace

MotionPlot::MotionPlot(QWidget* parent) : QWidget(parent)
{
    setMinimumHeight(92);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    withAccessibleName(this, [] { return tr("Vessel motion by frame"); });
}

void MotionPlot::showMotion(const std::vector<FrameMotion>& motion)
{
    motion_ = motion;
    maxMm_ = minAxisMm;
    for (const FrameMotion& frame : motion_) {
        maxMm_ = std::max(maxMm_, frame.inPlaneMm);
    }
    update();
}

void MotionPlot::showCurrent(int frame)
{
    current_ = frame;
    update();
}

QRectF MotionPlot::area() const
{
    return QRectF(rect()).adjusted(4, 6, -4, -motionLabelHeight);
}

double MotionPlot::xOf(std::size_t index) const
{
    const double last = static_cast<double>(std::max<std::size_t>(motion_.size(), 2) - 1);
    return area().left() + area().width() * static_cast<double>(index) / last;
}

std::size_t MotionPlot::indexAt(double x) const
{
    const double fraction = std::clamp((x - area().left()) / std::max(1.0, area().width()), 0.0, 1.0);
    return static_cast<std::size_t>(std::lround(fraction * static_cast<double>(motion_.size() - 1)));
}

void MotionPlot::paintLine(QPainter& painter) const
{
    const Palette& colors = activePalette();
    const QRectF plot = area();
    const auto positionOf = [&](std::size_t i) {
        return QPointF(xOf(i), plot.bottom() - motion_[i].inPlaneMm / maxMm_ * plot.height());
    };
    QPolygonF line;
    for (std::size_t i = 0; i < motion_.size(); ++i) {
        line << positionOf(i);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(toQColor(colors.accent), 1.5));
    painter.drawPolyline(line);
    for (std::size_t i = 0; i < motion_.size(); ++i) {
        const bool isSure = motion_[i].isTrustworthy;
        painter.setPen(QPen(toQColor(isSure ? colors.accent : colors.attention), 1.3));
        painter.setBrush(toQColor(isSure ? colors.accent : colors.panel));
        painter.drawEllipse(positionOf(i), isSure ? dotPx : dotPx + 1.0, isSure ? dotPx : dotPx + 1.0);
    }
}

void MotionPlot::paintEvent(QPaintEvent*)
{
    const Palette& colors = activePalette();
    QPainter painter(this);
    const QRectF plot = area();
    painter.setPen(toQColor(colors.line));
    painter.drawLine(plot.bottomLeft(), plot.bottomRight());
    if (motion_.empty()) {
        return;
    }
    const auto shown = std::ranges::find(motion_, current_, &FrameMotion::frame);
    if (shown != motion_.end()) {
        const double x = xOf(static_cast<std::size_t>(shown - motion_.begin()));
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    }
    paintLine(painter);
    painter.setPen(toQColor(colors.hint));
    const QRectF labels(plot.left(), plot.bottom() + 2, plot.width(), motionLabelHeight - 2);
    painter.drawText(labels, Qt::AlignLeft | Qt::AlignTop, tr("frame %1").arg(motion_.front().frame + 1));
    painter.drawText(labels, Qt::AlignRight | Qt::AlignTop, QString::number(motion_.back().frame + 1));
    painter.drawText(plot, Qt::AlignLeft | Qt::AlignTop, tr("%1 mm").arg(numberText(maxMm_, 1)));
    if (hasFocus()) {
        painter.setPen(toQColor(colors.accent));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void MotionPlot::request(std::size_t index)
{
    if (index < motion_.size() && motion_[index].frame != current_) {
        emit frameRequested(motion_[index].frame);
    }
}

void MotionPlot::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && !motion_.empty()) {
        request(indexAt(event->position().x()));
    }
}

void MotionPlot::mouseMoveEvent(QMouseEvent* event)
{
    if (motion_.empty()) {
        return;
    }
    const FrameMotion& at = motion_[indexAt(event->position().x())];
    const QString text = tr("frame %1: %2 mm in plane, %3 mm in depth, %4°")
                             .arg(at.frame + 1)
                             .arg(numberText(at.inPlaneMm, 2))
                             .arg(numberText(at.depthMm, 1))
                             .arg(numberText(at.rotationDeg, 1));
    QToolTip::showText(event->globalPosition().toPoint(),
                       at.isTrustworthy ? text : tr("%1 (not explained by the vessels)").arg(text), this);
    if (event->buttons().testFlag(Qt::LeftButton)) {
        request(indexAt(event->position().x()));
    }
}

void MotionPlot::keyPressEvent(QKeyEvent* event)
{
    const auto shown = std::ranges::find(motion_, current_, &FrameMotion::frame);
    const bool isStep = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right;
    if (!isStep || shown == motion_.end()) {
        QWidget::keyPressEvent(event);
        return;
    }
    const auto index = static_cast<std::size_t>(shown - motion_.begin());
    request(event->key() == Qt::Key_Right ? index + 1 : index - (index > 0 ? 1 : 0));
}

}   // namespace angiopose::ui
