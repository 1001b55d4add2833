#include "ui/slices/mask_tools.h"

#include "ui/slices/slice_view.h"
#include "ui/theme/active_theme.h"

#include <QKeyEvent>
#include <QPainter>

#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

using core::BrushMode;

constexpr double brushGrowth = 1.15;   // factor of the radius per wheel step
constexpr double minStepPx = 2.0;
constexpr std::size_t minVertices = 3;

const Palette& colors()
{
    return palette(ThemeMode::Dark);   // images have a dark background in every theme
}

}   // namespace

MaskBrushTool::MaskBrushTool(BrushMode mode, SliceModel& model) : SliceTool(model), mode_(mode), strokeMode_(mode) {}

void MaskBrushTool::setRadiusMm(double radiusMm)
{
    radiusMm_ = radiusMm;
    requestRepaint();
}

QString MaskBrushTool::caption() const
{
    return (mode_ == BrushMode::Paint ? tr("Paint: drag, Ctrl erases") : tr("Erase: drag, Ctrl paints")) +
           QStringLiteral(" · ") + tr("Shift+wheel, + and − change the brush size");
}

void MaskBrushTool::end()
{
    if (std::exchange(isStroking_, false)) {
        emit strokeEnded();
    }
    hoveredView_ = nullptr;
}

void MaskBrushTool::brushTo(const SlicePointer& pointer)
{
    hoveredView_ = &pointer.view;
    pointer_ = pointer.position;
    emit brushed(strokeMode_, pointer.view.grid(),
                 {std::exchange(last_, pointer.pointInPatient), pointer.pointInPatient});
    requestRepaint();
}

bool MaskBrushTool::startDrag(const SlicePointer& pressed)
{
    const bool isOther = pressed.modifiers.testFlag(Qt::ControlModifier);
    strokeMode_ = isOther == (mode_ == BrushMode::Paint) ? BrushMode::Erase : BrushMode::Paint;
    isStroking_ = true;
    last_ = pressed.pointInPatient;
    brushTo(pressed);
    return true;
}

void MaskBrushTool::drag(const SlicePointer& pointer)
{
    if (isStroking_) {
        brushTo(pointer);
    }
}

void MaskBrushTool::finishDrag(const SlicePointer& pointer)
{
    if (isStroking_) {
        brushTo(pointer);
        isStroking_ = false;
        emit strokeEnded();
    }
}

bool MaskBrushTool::click(const SlicePointer& pointer)
{
    startDrag(pointer);
    isStroking_ = false;
    emit strokeEnded();
    return true;
}

void MaskBrushTool::hover(const SlicePointer& pointer)
{
    hoveredView_ = &pointer.view;
    pointer_ = pointer.position;
    requestRepaint();
}

void MaskBrushTool::leave()
{
    hoveredView_ = nullptr;
    requestRepaint();
}

bool MaskBrushTool::wheel(const SlicePointer& pointer, double steps)
{
    if (!pointer.modifiers.testFlag(Qt::ShiftModifier)) {
        return false;
    }
    emit radiusRequested(radiusMm_ * std::pow(brushGrowth, steps));
    return true;
}

bool MaskBrushTool::takesKey(const QKeyEvent& event) const
{
    const int key = event.key();
    return !event.modifiers().testFlag(Qt::ControlModifier) &&
           (key == Qt::Key_Plus || key == Qt::Key_Equal || key == Qt::Key_Minus);
}

void MaskBrushTool::keyPress(const QKeyEvent& event)
{
    emit radiusRequested(radiusMm_ * (event.key() == Qt::Key_Minus ? 1.0 / brushGrowth : brushGrowth));
}

bool MaskBrushTool::undoStep()
{
    const bool wasStroking = std::exchange(isStroking_, false);
    if (wasStroking) {
        emit strokeEnded();   // makes the unfinished stroke one undo step
    }
    return wasStroking;
}

void MaskBrushTool::paint(QPainter& painter, SliceView& view) const
{
    if (hoveredView_ != &view) {
        return;
    }
    const double radiusPx = radiusMm_ * view.pxPerMm();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(toQColor(colors().canvas, 0.7), 3.0));
    painter.drawEllipse(pointer_, radiusPx, radiusPx);
    const bool erases =
        (isStroking_ ? strokeMode_ : mode_) == BrushMode::Erase;   // dashes as well as color show erasing
    painter.setPen(
        QPen(toQColor(erases ? colors().attention : colors().accent), 1.5, erases ? Qt::DashLine : Qt::SolidLine));
    painter.drawEllipse(pointer_, radiusPx, radiusPx);
    painter.restore();
}

QString MaskCutTool::caption() const
{
    return tr("Scissors: draw around the region to remove · Shift keeps only the inside");
}

void MaskCutTool::end()
{
    outline_.clear();
    view_ = nullptr;
}

bool MaskCutTool::startDrag(const SlicePointer& pressed)
{
    view_ = &pressed.view;
    outline_ = {pressed.pointInPatient};
    return true;
}

void MaskCutTool::drag(const SlicePointer& pointer)
{
    if (!outline_.empty() && (pointer.pointInPatient - outline_.back()).norm() * pointer.view.pxPerMm() >= minStepPx) {
        outline_.push_back(pointer.pointInPatient);
        requestRepaint();
    }
}

void MaskCutTool::finishDrag(const SlicePointer& pointer)
{
    const std::vector<Eigen::Vector3d> outline = std::exchange(outline_, {});
    requestRepaint();
    if (outline.size() < minVertices) {
        return;
    }
    core::MaskCut whole;
    whole.slice = pointer.view.grid();
    for (const Eigen::Vector3d& corner : outline) {
        whole.outline.push_back(whole.slice.pixelOf(corner));
    }
    whole.side = pointer.modifiers.testFlag(Qt::ShiftModifier) ? core::CutSide::Outside : core::CutSide::Inside;
    emit cut(whole);
}

bool MaskCutTool::undoStep()
{
    const bool isDrawn = !outline_.empty();
    end();
    requestRepaint();
    return isDrawn;
}

void MaskCutTool::paint(QPainter& painter, SliceView& view) const
{
    if (view_ != &view || outline_.size() < 2) {
        return;
    }
    QPolygonF shown;
    for (const Eigen::Vector3d& corner : outline_) {
        shown << view.widgetFromPatient(corner);
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(toQColor(colors().attention), 1.5, Qt::DashLine));
    painter.setBrush(toQColor(colors().attention, 0.12));
    painter.drawPolygon(shown);
    painter.restore();
}

}   // namespace angiopose::ui
