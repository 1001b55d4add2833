#include "ui/views/tools/nudge_tool.h"

#include "ui/theme/theme.h"
#include "ui/views/angiogram_view.h"
#include "ui/words/number.h"

#include <QCursor>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr int sizePx = 26;

QPainterPath arrowHead(const QPointF& tip, const QPointF& back, const QPointF& aside)
{
    QPainterPath head(tip);
    head.lineTo(tip + back + aside);
    head.lineTo(tip + back - aside);
    head.closeSubpath();
    return head;
}

/// Returns the cursor over the roll ring, a curved double arrow.
QCursor rollCursor()
{
    QPixmap picture(sizePx, sizePx);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    const Color strong = palette(ThemeMode::Dark).textStrong;
    const QColor light(strong.red, strong.green, strong.blue);
    QPainterPath arc;
    const QRectF circle(5.0, 5.0, 16.0, 16.0);
    arc.arcMoveTo(circle, 25.0);
    arc.arcTo(circle, 25.0, 130.0);
    arc.arcMoveTo(circle, 205.0);
    arc.arcTo(circle, 205.0, 130.0);
    const QPainterPath heads =
        arrowHead({22.0, 15.0}, {-0.5, -6.0}, {4.0, 0.5}).united(arrowHead({4.0, 11.0}, {0.5, 6.0}, {4.0, 0.5}));
    painter.strokePath(arc, QPen(Qt::black, 4.5));
    painter.strokePath(heads, QPen(Qt::black, 2.0));
    painter.strokePath(arc, QPen(light, 2.0));
    painter.fillPath(heads, light);
    painter.end();
    return QCursor(picture, sizePx / 2, sizePx / 2);
}

constexpr double fineNudgePace = 0.1;

Eigen::Vector2d nudgeVector(const QPointF& point)
{
    return {point.x(), point.y()};
}

/// Flips the right shift and the roll, which are defined in the image, for the mirrored view from the source.
core::PoseOffset asSeen(core::PoseOffset offset, const AngiogramView& view)
{
    if (view.isFromSource()) {
        offset.rightMm = -offset.rightMm;
        offset.rollDeg = -offset.rollDeg;
    }
    return offset;
}

}   // namespace

QString NudgeTool::caption() const
{
    return tr("Nudge: drag to move · ring to roll · arcs to tilt · slider for depth · Ctrl = fine · Esc cancels");
}

const Color& NudgeTool::tone() const
{
    return palette(ThemeMode::Dark).attention;
}

void NudgeTool::end()
{
    hoveredHandle_ = PoseHandle::None;
}

NudgeGrip NudgeTool::grip() const
{
    const core::ProjectionCamera& camera = view().camera();
    const Eigen::Vector3d pivotInCamera = view().cameraFromPatient() * view().pivotInPatient();
    const auto pixel = !core::findProblem(camera) ? core::project(camera, pivotInCamera) : std::nullopt;
    if (!pixel) {
        return {};
    }
    const double scale = pivotInCamera.z() / view().zoom();
    const double radius = std::clamp(0.12 * std::min(view().width(), view().height()), 44.0, 110.0);
    return {nudgeVector(view().widgetFromImage(*pixel)),
            radius,
            {scale / std::abs(camera.fx), scale / std::abs(camera.fy)}};
}

bool NudgeTool::startDrag(const ToolPoint& pressed)
{
    const NudgeGrip grasped = grip();
    const PoseHandle handle = handleAt(grasped, nudgeVector(pressed.position));
    if (handle != PoseHandle::None) {
        nudge_.emplace(handle, grasped, nudgeVector(pressed.position));
        dragged_ = {};
        emit dragStarted();
    }
    return true;   // accepts every drag, so that window/level does not change next to the tree
}

void NudgeTool::drag(const ToolPoint& point)
{
    if (nudge_) {
        const double speedFactor = point.modifiers.testFlag(Qt::ControlModifier) ? fineNudgePace : 1.0;
        dragged_ = asSeen(nudge_->moveTo(nudgeVector(point.position), speedFactor), view());
        view().redraw();
        emit dragged(dragged_);
    }
}

void NudgeTool::finishDrag(const ToolPoint&)
{
    if (nudge_) {
        nudge_.reset();
        emit dragFinished();
    }
}

void NudgeTool::cancelDrag()
{
    if (nudge_) {
        nudge_.reset();
        emit dragCancelled();
    }
}

void NudgeTool::hover(const ToolPoint& point)
{
    const NudgeGrip grasped = grip();
    const PoseHandle handle = handleAt(grasped, nudgeVector(point.position));
    hoveredAngleRad_ = screenAngleRad(grasped.center, nudgeVector(point.position));
    if (handle != hoveredHandle_ || handle == PoseHandle::Roll) {
        view().redraw();
    }
    hoveredHandle_ = handle;
}

void NudgeTool::leave()
{
    hoveredHandle_ = PoseHandle::None;
}

bool NudgeTool::takesKey(const QKeyEvent& event) const
{
    return nudgeOfKey(event.key(), event.modifiers()).has_value();
}

void NudgeTool::keyPress(const QKeyEvent& event)
{
    if (auto nudge = nudgeOfKey(event.key(), event.modifiers())) {
        const bool isMirrored = nudge->axis == PoseAxis::Right || nudge->axis == PoseAxis::Roll;
        nudge->amount *= isMirrored && view().isFromSource() ? -1.0 : 1.0;
        emit keyNudged(*nudge);
    }
}

std::optional<QCursor> NudgeTool::cursor(bool) const
{
    const PoseHandle handle = nudge_ ? nudge_->handle() : hoveredHandle_;
    switch (handle) {
        case PoseHandle::Roll:
            return rollCursor();
        case PoseHandle::LaoRao:
            return QCursor(Qt::SizeHorCursor);
        case PoseHandle::CraCau:
        case PoseHandle::Depth:
            return QCursor(Qt::SizeVerCursor);
        default:
            return QCursor(Qt::SizeAllCursor);
    }
}

PoseHandleState NudgeTool::handleState() const
{
    const double ratio = view().devicePixelRatio();
    const NudgeGrip grasped = grip();
    PoseHandleState shown;
    if (!(grasped.ringRadius > 0.0)) {
        return shown;
    }
    shown.center = grasped.center * ratio;
    shown.radius = grasped.ringRadius * ratio;
    shown.pixelScale = ratio;
    shown.hovered = hoveredHandle_;
    shown.rollStartRad = -hoveredAngleRad_;
    if (nudge_) {
        shown.active = nudge_->handle();
        shown.rollStartRad = -nudge_->startAngleRad();
        shown.rollSweepRad = -nudge_->sweepRad();
        shown.slidePx = nudge_->slidePx() * ratio;
    }
    return shown;
}

StrokeMesh NudgeTool::strokes(int heightPx) const
{
    PoseHandleState shown = handleState();
    shown.center.y() = heightPx - shown.center.y();
    return poseHandleStrokes(shown);
}

/// Returns the name of the handle under the pointer or, during a drag, the amount of the change.
QString NudgeTool::offsetText() const
{
    const auto amount = [this](PoseAxis axis) {
        const double value = valueOf(dragged_, axis);
        const QString number = (value < 0.0 ? QStringLiteral("−") : QStringLiteral("+")) +
                               numberText(std::abs(value), isShift(axis) ? 2 : 1);
        return number + (isShift(axis) ? QStringLiteral(" mm") : QStringLiteral("°"));
    };
    const PoseHandle handle = nudge_ ? nudge_->handle() : hoveredHandle_;
    const bool isShifted = handle == PoseHandle::Shift;
    if (handle == PoseHandle::None || (isShifted && !nudge_)) {
        return {};
    }
    if (isShifted) {
        return amount(PoseAxis::Right) + QStringLiteral("  ↑ ") + amount(PoseAxis::Up);
    }
    const PoseAxis axis = handle == PoseHandle::Roll     ? PoseAxis::Roll
                          : handle == PoseHandle::LaoRao ? PoseAxis::LaoRao
                          : handle == PoseHandle::CraCau ? PoseAxis::CraCau
                                                         : PoseAxis::AlongRay;
    return nudge_ ? labelOf(axis) + QLatin1Char(' ') + amount(axis) : labelOf(axis);
}

void NudgeTool::paint(QPainter& painter) const
{
    const NudgeGrip grasped = grip();
    const QString text = grasped.ringRadius > 0.0 ? offsetText() : QString();
    if (text.isEmpty()) {
        return;
    }
    QFont font = painter.font();
    font.setPixelSize(12);
    painter.setFont(font);
    const double width = painter.fontMetrics().horizontalAdvance(text) + 16.0;
    const double above = grasped.center.y() - grasped.ringRadius - outerHandleGapPx - 8.0;
    QRectF box(grasped.center.x() - 0.5 * width, above - 20.0, width, 20.0);
    box.moveTo(std::clamp(box.left(), 4.0, std::max(4.0, view().width() - width - 4.0)),
               std::clamp(box.top(), 30.0, std::max(30.0, view().height() - 24.0)));
    QColor background(0, 0, 0, 165);
    painter.fillRect(box, background);
    const Color& shade = nudge_ ? tone() : palette(ThemeMode::Dark).text;
    painter.setPen(QColor(shade.red, shade.green, shade.blue));
    painter.drawText(box, Qt::AlignCenter, text);
}

}   // namespace angiopose::ui
