#include "ui/plots/frame_bars.h"

#include "ui/theme/active_theme.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr double laneHeight = 9.0;   // height of the lane above the bars, px
constexpr double handleReachPx = 7.0;
constexpr double gripWidth = 4.0;

bool isInLane(const QPointF& pos)
{
    return pos.y() < laneHeight;
}

}   // namespace

QString describeFrame(const FrameCurve& curve, const std::vector<int>& masks, int frame)
{
    QStringList parts{FrameBars::tr("Frame %1").arg(frame + 1)};
    if (curve.frameTimeMs > 0.0) {
        parts << FrameBars::tr("%1 s").arg(numberText(0.001 * curve.frameTimeMs * frame, 2));
    }
    if (frame >= 0 && frame < static_cast<int>(curve.opacification.size())) {
        parts << QStringLiteral("%1 %").arg(qRound(100.0 * curve.opacification[static_cast<std::size_t>(frame)]));
    }
    if (frame == curve.suggested) {
        parts << FrameBars::tr("peak-opacification frame");
    }
    if (std::ranges::find(masks, frame) != masks.end()) {
        parts << FrameBars::tr("mask");
    }
    if (std::ranges::find(curve.rWaves, frame) != curve.rWaves.end()) {
        parts << FrameBars::tr("R wave");
    }
    return parts.join(QStringLiteral(" · "));
}

FrameBars::FrameBars(QWidget* parent) : QWidget(parent)
{
    setMinimumHeight(40);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    withAccessibleName(this, [] { return tr("Opacification of the frames"); });
}

void FrameBars::showFrames(const FrameCurve& curve)
{
    curve_ = curve;
    markedRange_.reset();
    draggedEnd_.reset();
    setCursor(curve_.opacification.size() > 1 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    update();
}

void FrameBars::showMasks(const std::vector<int>& frames, bool inUse)
{
    masks_ = frames;
    masksInUse_ = inUse;
    update();
}

bool FrameBars::isMask(int frame) const
{
    if (markedRange_) {
        const auto [low, high] = std::minmax(markedRange_->first, markedRange_->second);
        return frame >= low && frame <= high;
    }
    return std::ranges::find(masks_, frame) != masks_.end();
}

void FrameBars::showCurrent(int frame)
{
    current_ = frame;
    update();
}

void FrameBars::showLoop(const core::FrameRange& range)
{
    loop_ = range;
    update();
}

QRectF FrameBars::cellOf(int frame) const
{
    const double slot = width() / static_cast<double>(std::max(1, frameCount()));
    const double gap = slot > 12.0 ? 3.0 : slot > 4.0 ? 1.0 : 0.0;
    return {slot * frame + 1.0, laneHeight + 1.0, std::max(1.0, slot - gap - 1.0), height() - laneHeight - 2.0};
}

void FrameBars::paintCell(QPainter& painter, int frame) const
{
    const Palette& colors = activePalette();
    const QRectF cell = cellOf(frame);
    painter.setOpacity(loop_.contains(frame) ? 1.0 : 0.45);   // dims frames outside the playback range
    painter.fillRect(cell, toQColor(colors.field));
    const double filled = std::clamp(curve_.opacification[static_cast<std::size_t>(frame)], 0.0, 1.0) * cell.height();
    painter.fillRect(QRectF(cell.left(), cell.bottom() - filled, cell.width(), filled),
                     toQColor(colors.accent, frame == current_ ? 0.55 : 0.28));
    if (frame == curve_.suggested && cell.width() > 7.0) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(toQColor(colors.fine));
        painter.drawEllipse(QPointF(cell.center().x(), cell.top() + 6.0), 2.5, 2.5);
        painter.setBrush(Qt::NoBrush);
    }
    if (isMask(frame)) {
        const double strength = masksInUse_ || markedRange_ ? 1.0 : 0.5;
        painter.fillRect(QRectF(cell.left(), cell.bottom() - 3.0, cell.width(), 3.0),
                         toQColor(colors.attention, strength));
    }
    painter.setOpacity(1.0);
    if (frame == current_) {
        painter.setPen(QPen(toQColor(colors.accent), hasFocus() ? 2.0 : 1.5));
        painter.drawRoundedRect(cell, 2.0, 2.0);
    }
}

/// Paints the playback range as a line with a grip at each end.
void FrameBars::paintLoop(QPainter& painter) const
{
    const Palette& colors = activePalette();
    const double from = cellOf(loop_.first).left();
    const double to = cellOf(loop_.last).right();
    const bool isPart = loop_.count() < frameCount();
    const QColor tone = toQColor(isPart || draggedEnd_ ? colors.accent : colors.hint);
    painter.fillRect(QRectF(from, 0.5 * laneHeight - 1.0, to - from, 1.5), tone);
    painter.setPen(Qt::NoPen);
    painter.setBrush(tone);
    for (const double x : {from, to - gripWidth}) {
        painter.drawRoundedRect(QRectF(x, 0.0, gripWidth, laneHeight - 1.0), 1.5, 1.5);
    }
    painter.setBrush(Qt::NoBrush);
}

/// Paints a spike at each R wave in the lane above the bars.
void FrameBars::paintBeats(QPainter& painter) const
{
    painter.setPen(QPen(toQColor(activePalette().textStrong), 1.2));
    for (const int frame : curve_.rWaves) {
        if (frame < frameCount()) {
            const double x = cellOf(frame).center().x();
            const double base = laneHeight - 1.0;
            painter.drawPolyline(QPolygonF({{x - 4.0, base - 2.0},
                                            {x - 1.5, base - 2.0},
                                            {x, 0.5},
                                            {x + 1.5, base},
                                            {x + 2.5, base - 2.0},
                                            {x + 5.0, base - 2.0}}));
        }
    }
}

void FrameBars::paintEvent(QPaintEvent*)
{
    if (curve_.opacification.empty()) {
        return;
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (int frame = 0; frame < frameCount(); ++frame) {
        paintCell(painter, frame);
    }
    if (frameCount() > 1) {
        paintLoop(painter);
        paintBeats(painter);
    }
}

int FrameBars::frameAt(double x) const
{
    const int count = static_cast<int>(curve_.opacification.size());
    return std::clamp(static_cast<int>(x / std::max(1, width()) * count), 0, count - 1);
}

void FrameBars::request(int frame)
{
    if (!curve_.opacification.empty() && frame != current_) {
        emit frameRequested(std::clamp(frame, 0, static_cast<int>(curve_.opacification.size()) - 1));
    }
}

std::optional<FrameBars::LoopEnd> FrameBars::loopEndAt(const QPointF& pos) const
{
    if (!isInLane(pos) || frameCount() < 2) {
        return std::nullopt;
    }
    const double toFirst = std::abs(pos.x() - cellOf(loop_.first).left() - 0.5 * gripWidth);
    const double toLast = std::abs(pos.x() - cellOf(loop_.last).right() + 0.5 * gripWidth);
    if (std::min(toFirst, toLast) > handleReachPx) {
        return std::nullopt;
    }
    return toFirst < toLast ? LoopEnd::First : LoopEnd::Last;
}

void FrameBars::dragLoop(int frame)
{
    core::FrameRange range = loop_;
    if (range.count() == 1) {   // the direction of the drag selects one of two coincident grips
        draggedEnd_ = frame < range.first ? LoopEnd::First : LoopEnd::Last;
    }
    if (*draggedEnd_ == LoopEnd::First) {
        range.first = std::min(frame, loop_.last);
    } else {
        range.last = std::max(frame, loop_.first);
    }
    if (range != loop_) {
        emit loopMarked(range);
    }
    update();
}

void FrameBars::pressBars(int frame, Qt::KeyboardModifiers modifiers)
{
    if (modifiers.testFlag(Qt::ShiftModifier)) {
        markedRange_ = {frame, frame};
        update();
    } else {
        request(frame);
    }
}

void FrameBars::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || curve_.opacification.empty()) {
        return;
    }
    draggedEnd_ = loopEndAt(event->position());
    if (!isInLane(event->position()) || frameCount() < 2) {
        pressBars(frameAt(event->position().x()), event->modifiers());
    }
}

void FrameBars::mouseMoveEvent(QMouseEvent* event)
{
    if (curve_.opacification.empty()) {
        return;
    }
    const int frame = frameAt(event->position().x());
    const bool isAtGrip = draggedEnd_ || loopEndAt(event->position());
    setCursor(isAtGrip ? Qt::SizeHorCursor : frameCount() > 1 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    setToolTip(describeFrame(curve_, masks_, frame) + QLatin1Char('\n') +
               (isInLane(event->position())
                    ? tr("Drag the ends to play part of the run; double-click to play the whole run")
                    : tr("Shift+drag marks mask frames; double-click shows the opacification curve")));
    if (draggedEnd_) {
        dragLoop(frame);
    } else if (markedRange_) {
        markedRange_->second = frame;
        update();
    } else if (event->buttons() & Qt::LeftButton) {
        request(frame);
    }
}

void FrameBars::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && std::exchange(draggedEnd_, std::nullopt)) {
        update();
    } else if (event->button() == Qt::LeftButton && markedRange_) {
        const auto [from, to] = *std::exchange(markedRange_, std::nullopt);
        const int low = std::min(from, to);
        const int high = std::max(from, to);
        emit maskRangeMarked(low, high);
        update();
    }
}

void FrameBars::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || curve_.opacification.empty()) {
        return;
    }
    if (isInLane(event->position())) {
        emit loopMarked({0, frameCount() - 1});
    } else {
        emit plotRequested();
    }
}

/// Marks mask frames with the keyboard: starts at the current frame, or extends a range that ends there.
void FrameBars::extendMask(int step)
{
    const int last = static_cast<int>(curve_.opacification.size()) - 1;
    const int next = std::clamp(current_ + step, 0, last);
    const bool shouldContinue = !masks_.empty() && (masks_.front() == current_ || masks_.back() == current_);
    int low = std::min(current_, next);
    int high = std::max(current_, next);
    if (shouldContinue) {
        low = std::min(low, masks_.front());
        high = std::max(high, masks_.back());
    }
    request(next);
    emit maskRangeMarked(low, high);
}

void FrameBars::keyPressEvent(QKeyEvent* event)
{
    const int last = static_cast<int>(curve_.opacification.size()) - 1;
    const bool marks = event->modifiers().testFlag(Qt::ShiftModifier) && last > 0;
    if (marks && (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right)) {
        return extendMask(event->key() == Qt::Key_Left ? -1 : 1);
    }
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

}   // namespace angiopose::ui
