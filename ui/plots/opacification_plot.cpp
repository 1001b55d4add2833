#include "ui/plots/opacification_plot.h"

#include "ui/theme/active_theme.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr double leftMargin = 54.0;
constexpr double rightMargin = 26.0;
constexpr double topMargin = 26.0;
constexpr double bottomMargin = 34.0;

/// Returns a round interval between labels that gives about eight labels on the x axis.
int labelStep(int frameCount)
{
    int step = 1;
    for (const int candidate : {1, 2, 5, 10, 20, 50, 100, 200, 500}) {
        step = candidate;
        if (frameCount <= 9 * candidate) {
            break;
        }
    }
    return step;
}

}   // namespace

OpacificationPlot::OpacificationPlot(QWidget* parent) : QWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(360, 200);
    withAccessibleName(this, [] { return tr("Opacification by frame"); });
}

void OpacificationPlot::showFrames(const FrameCurve& curve)
{
    curve_ = curve;
    hovered_.reset();
    update();
}

void OpacificationPlot::showMasks(const std::vector<int>& frames)
{
    masks_ = frames;
    update();
}

void OpacificationPlot::showCurrent(int frame)
{
    current_ = frame;
    update();
}

QRectF OpacificationPlot::area() const
{
    return {leftMargin, topMargin, width() - leftMargin - rightMargin, height() - topMargin - bottomMargin};
}

QPointF OpacificationPlot::pointOf(int frame) const
{
    const QRectF part = area();
    if (frame < 0 || frame > lastFrame()) {
        return part.bottomLeft();
    }
    const double fraction = std::clamp(curve_.opacification[static_cast<std::size_t>(frame)], 0.0, 1.0);
    return {part.left() + part.width() * frame / std::max(1, lastFrame()), part.bottom() - fraction * part.height()};
}

int OpacificationPlot::frameAt(double x) const
{
    const QRectF part = area();
    return std::clamp(static_cast<int>(std::lround((x - part.left()) / part.width() * lastFrame())), 0, lastFrame());
}

void OpacificationPlot::paintAxes(QPainter& painter) const
{
    const Palette& colors = activePalette();
    const QRectF part = area();
    for (const int percent : {0, 50, 100}) {
        const double y = part.bottom() - 0.01 * percent * part.height();
        painter.setPen(QPen(toQColor(colors.line), 1.0));
        painter.drawLine(QPointF(part.left(), y), QPointF(part.right(), y));
        painter.setPen(toQColor(colors.hint));
        painter.drawText(QRectF(0.0, y - 9.0, leftMargin - 8.0, 18.0), Qt::AlignRight | Qt::AlignVCenter,
                         QStringLiteral("%1 %").arg(percent));
    }
    const int step = labelStep(lastFrame() + 1);
    for (int frame = 0; frame <= lastFrame(); frame += step) {
        const double x = pointOf(frame).x();
        const QString text = curve_.frameTimeMs > 0.0
                                 ? tr("%1 · %2 s").arg(frame + 1).arg(numberText(0.001 * curve_.frameTimeMs * frame, 2))
                                 : QString::number(frame + 1);
        const double half = std::min(50.0, width() - 2.0 - x);   // keeps the last label inside the plot
        painter.drawText(QRectF(x + half - 100.0, part.bottom() + 6.0, 100.0, 18.0),
                         half < 50.0 ? Qt::AlignRight : Qt::AlignHCenter, text);
    }
}

void OpacificationPlot::paintCurve(QPainter& painter) const
{
    const Palette& colors = activePalette();
    const QRectF part = area();
    const double halfSlot = 0.5 * part.width() / std::max(1, lastFrame());
    for (const int frame : masks_) {
        if (frame <= lastFrame()) {
            painter.fillRect(
                QRectF(pointOf(frame).x() - halfSlot, part.top(), 2.0 * halfSlot, part.height()).intersected(part),
                toQColor(colors.attention, 0.18));
        }
    }
    QPainterPath path(pointOf(0));
    for (int frame = 1; frame <= lastFrame(); ++frame) {
        path.lineTo(pointOf(frame));
    }
    painter.strokePath(path, QPen(toQColor(colors.accent), 1.5));
    painter.setPen(QPen(toQColor(colors.accent), 1.0));
    painter.drawLine(QPointF(pointOf(current_).x(), part.top()), QPointF(pointOf(current_).x(), part.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(toQColor(colors.fine));
    painter.drawEllipse(pointOf(std::clamp(curve_.suggested, 0, lastFrame())), 4.5, 4.5);
    painter.setBrush(toQColor(colors.textStrong));
    painter.drawEllipse(pointOf(hovered_.value_or(current_)), 3.5, 3.5);
}

void OpacificationPlot::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), toQColor(activePalette().field));
    if (lastFrame() < 1) {
        painter.setPen(toQColor(activePalette().hint));
        painter.drawText(rect(), Qt::AlignCenter, tr("The curve requires a run with several frames"));
        return;
    }
    if (current_ <= lastFrame()) {
        paintAxes(painter);
        paintCurve(painter);
        painter.setPen(toQColor(activePalette().text));
        painter.drawText(QRectF(leftMargin, 4.0, area().width(), 18.0), Qt::AlignLeft | Qt::AlignVCenter,
                         describeFrame(curve_, masks_, hovered_.value_or(current_)));
    }
}

void OpacificationPlot::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && lastFrame() > 0) {
        emit frameRequested(frameAt(event->position().x()));
    }
}

void OpacificationPlot::mouseMoveEvent(QMouseEvent* event)
{
    if (lastFrame() > 0) {
        hovered_ = frameAt(event->position().x());
        if (event->buttons() & Qt::LeftButton) {
            emit frameRequested(*hovered_);
        }
        update();
    }
}

void OpacificationPlot::leaveEvent(QEvent*)
{
    hovered_.reset();
    update();
}

void OpacificationPlot::keyPressEvent(QKeyEvent* event)
{
    const int step = event->key() == Qt::Key_Left ? -1 : event->key() == Qt::Key_Right ? 1 : 0;
    if (step == 0 || lastFrame() < 1) {
        QWidget::keyPressEvent(event);
        return;
    }
    emit frameRequested(std::clamp(current_ + step, 0, lastFrame()));
}

}   // namespace angiopose::ui
