#include "ui/plots/frame_bars.h"

#include "ui/theme/active_theme.h"
#include "ui/words/number.h"
#include "ui/words/spoken.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace angiopose::ui {

QString describeFrame(const FrameCurve& curve, const std::vector<int>& masks, int frame)
{
    QStringList parts{FrameBars::tr("Frame %1").arg(frame)};
    if (curve.frameTimeMs > 0.0) {
        parts << FrameBars::tr("%1 s").arg(numberText(0.001 * curve.frameTimeMs * frame, 2));
    }
    if (frame >= 0 && frame < static_cast<int>(curve.opacification.size())) {
        parts << QStringLiteral("%1 %").arg(qRound(100.0 * curve.opacification[static_cast<std::size_t>(frame)]));
    }
    if (frame == curve.suggested) {
        parts << FrameBars::tr("the fullest");
    }
    if (std::ranges::find(masks, frame) != masks.end()) {
        parts << FrameBars::tr("mask");
    }
    return parts.join(QStringLiteral(" · "));
}

FrameBars::FrameBars(QWidget* parent) : QWidget(parent)
{
    setMinimumHeight(36);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    withName(this, [] { return tr("Frames by opacification"); });
}

void FrameBars::showFrames(const FrameCurve& curve)
{
    curve_ = curve;
    marking_.reset();
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
    if (marking_) {
        const auto [low, high] = std::minmax(marking_->first, marking_->second);
        return frame >= low && frame <= high;
    }
    return std::ranges::find(masks_, frame) != masks_.end();
}

void FrameBars::showCurrent(int frame)
{
    current_ = frame;
    update();
}

void FrameBars::paintEvent(QPaintEvent*)
{
    if (curve_.opacification.empty()) {
        return;
    }
    const Palette& tones = activePalette();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double slot = width() / static_cast<double>(curve_.opacification.size());
    const double gap = slot > 12.0 ? 3.0 : slot > 4.0 ? 1.0 : 0.0;
    for (std::size_t i = 0; i < curve_.opacification.size(); ++i) {
        const QRectF cell(slot * static_cast<double>(i) + 1.0, 1.0, std::max(1.0, slot - gap - 1.0), height() - 2.0);
        painter.fillRect(cell, toQColor(tones.field));
        const double filled = std::clamp(curve_.opacification[i], 0.0, 1.0) * cell.height();
        painter.fillRect(QRectF(cell.left(), cell.bottom() - filled, cell.width(), filled),
                         toQColor(tones.accent, static_cast<int>(i) == current_ ? 0.55 : 0.28));
        if (static_cast<int>(i) == curve_.suggested && slot > 10.0) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(toQColor(tones.fine));
            painter.drawEllipse(QPointF(cell.center().x(), cell.top() + 6.0), 2.5, 2.5);
            painter.setBrush(Qt::NoBrush);
        }
        if (isMask(static_cast<int>(i))) {
            const double strength = masksInUse_ || marking_ ? 1.0 : 0.5;
            painter.fillRect(QRectF(cell.left(), cell.bottom() - 3.0, cell.width(), 3.0),
                             toQColor(tones.attention, strength));
        }
        if (static_cast<int>(i) == current_) {
            painter.setPen(QPen(toQColor(tones.accent), hasFocus() ? 2.0 : 1.5));
            painter.drawRoundedRect(cell, 2.0, 2.0);
        }
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

void FrameBars::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || curve_.opacification.empty()) {
        return;
    }
    const int frame = frameAt(event->position().x());
    if (event->modifiers().testFlag(Qt::ShiftModifier)) {
        marking_ = {frame, frame};
        update();
    } else {
        request(frame);
    }
}

void FrameBars::mouseMoveEvent(QMouseEvent* event)
{
    if (curve_.opacification.empty()) {
        return;
    }
    const int frame = frameAt(event->position().x());
    setToolTip(describeFrame(curve_, masks_, frame) + QLatin1Char('\n') +
               tr("Shift+drag marks mask frames, double click shows the curve"));
    if (marking_) {
        marking_->second = frame;
        update();
    } else if (event->buttons() & Qt::LeftButton) {
        request(frame);
    }
}

void FrameBars::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && marking_) {
        const auto [from, to] = *std::exchange(marking_, std::nullopt);
        const int low = std::min(from, to);
        const int high = std::max(from, to);
        emit maskRangeMarked(low, high);
        update();
    }
}

void FrameBars::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && !curve_.opacification.empty()) {
        emit plotRequested();
    }
}

/// Marks by keys: from the current frame, or on from a range that ends there.
void FrameBars::extendMask(int step)
{
    const int last = static_cast<int>(curve_.opacification.size()) - 1;
    const int next = std::clamp(current_ + step, 0, last);
    const bool goesOn = !masks_.empty() && (masks_.front() == current_ || masks_.back() == current_);
    int low = std::min(current_, next);
    int high = std::max(current_, next);
    if (goesOn) {
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