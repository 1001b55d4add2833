#include "ui/views/tools/mask_shift_tool.h"

#include "ui/views/angiogram_view.h"
#include "ui/words/number.h"

#include <QKeyEvent>

namespace angiopose::ui {
namespace {

constexpr double stepPx = 0.25;
constexpr double fineMaskPace = 0.2;
constexpr double coarsePace = 4.0;

std::optional<Eigen::Vector2d> stepOf(const QKeyEvent& event)
{
    const double speedFactor = event.modifiers().testFlag(Qt::ShiftModifier)     ? coarsePace
                               : event.modifiers().testFlag(Qt::ControlModifier) ? fineMaskPace
                                                                                 : 1.0;
    const double step = speedFactor * stepPx;
    switch (event.key()) {
        case Qt::Key_Left:
            return Eigen::Vector2d(-step, 0.0);
        case Qt::Key_Right:
            return Eigen::Vector2d(step, 0.0);
        case Qt::Key_Up:
            return Eigen::Vector2d(0.0, -step);
        case Qt::Key_Down:
            return Eigen::Vector2d(0.0, step);
        default:
            return std::nullopt;
    }
}

}   // namespace

void MaskShiftTool::showShift(const Eigen::Vector2d& shiftPx)
{
    shift_ = shiftPx;
    view().redraw();
}

QString MaskShiftTool::caption() const
{
    return tr("Pixel shift: arrow keys or drag, Shift 1 px, Ctrl 0.05 px, Esc ends · right %1, down %2 px")
        .arg(numberText(shift_.x(), 2))
        .arg(numberText(shift_.y(), 2));
}

const Color& MaskShiftTool::tone() const
{
    return palette(ThemeMode::Dark).attention;
}

void MaskShiftTool::moveTo(const Eigen::Vector2d& shiftPx)
{
    shift_ = shiftPx;
    view().redraw();
    emit shifted(shift_);
}

bool MaskShiftTool::startDrag(const ToolPoint& pressed)
{
    shiftBefore_ = shift_;
    last_ = pressed.imagePx;
    return true;
}

void MaskShiftTool::drag(const ToolPoint& point)
{
    const double speedFactor = point.modifiers.testFlag(Qt::ControlModifier) ? fineMaskPace : 1.0;
    const Eigen::Vector2d step = speedFactor * (point.imagePx - last_);
    last_ = point.imagePx;
    moveTo(shift_ + step);
}

void MaskShiftTool::cancelDrag()
{
    moveTo(shiftBefore_);
}

bool MaskShiftTool::takesKey(const QKeyEvent& event) const
{
    return stepOf(event).has_value() && !event.modifiers().testFlag(Qt::AltModifier);
}

void MaskShiftTool::keyPress(const QKeyEvent& event)
{
    if (const auto step = stepOf(event)) {
        moveTo(shift_ + *step);
        emit shiftFinished();
    }
}

}   // namespace angiopose::ui
