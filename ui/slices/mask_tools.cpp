#include "ui/slices/mask_tools.h"

#include "ui/slices/slice_view.h"
#include "ui/theme/active_theme.h"

#include <QKeyEvent>
#include <QPainter>

#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

using core::MaskAim;

constexpr double brushGrowth = 1.15;   // factor of the radius per wheel step
constexpr double smallestStepPx = 2.0;
constexpr std::size_t fewestCorners = 3;

const Palette& tones()
{
    return palette(ThemeMode::Dark);   // images have a dark background in every theme
}

}   // namespace

MaskBrushTool::MaskBrushTool(MaskAim aim, SliceModel& model) : SliceTool(model), aim_(aim), now_(aim) {}

void MaskBrushTool::setRadiusMm(double radiusMm)
{
    radiusMm_ = radiusMm;
    lookAgain();
}

QString MaskBrushTool::caption() const
{
    return (aim_ == MaskAim::Paint ? tr("Paint: drag, Ctrl erases") : tr("Erase: drag, Ctrl paints")) +
           QStringLiteral(" · ") + tr("Shift+wheel, + and − change the brush size");
}

void MaskBrushTool::end()
{
    if (std::exchange(isStroking_, false)) {
        emit strokeEnded();
    }
    under_ = nullptr;
}

void MaskBrushTool::brushTo(const SlicePointer& pointer)
{
    under_ = &pointer.view;
    pointer_ = pointer.position;
    emit brushed(now_, pointer.view.grid(), {std::exchange(last_, pointer.pointInPatient), pointer.pointInPatient});
    lookAgain();
}

bool MaskBrushTool::startDrag(const SlicePointer& pressed)
{
    const bool isOther = pressed.modifiers.testFlag(Qt::ControlModifier);
    now_ = isOther == (aim_ == MaskAim::Paint) ? MaskAim::Erase : MaskAim::Paint;
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
    under_ = &pointer.view;
    pointer_ = pointer.position;
    lookAgain();
}

void MaskBrushTool::leave()
{
    under_ = nullptr;
    lookAgain();
}

bool MaskBrushTool::wheel(const SlicePointer& pointer, double steps)
{
    if (!pointer.modifiers.testFlag(Qt::ShiftModifier)) {
        return false;
    }
    emit radiusWanted(radiusMm_ * std::pow(brushGrowth, steps));
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
    emit radiusWanted(radiusMm_ * (event.key() == Qt::Key_Minus ? 1.0 / brushGrowth : brushGrowth));
}

bool MaskBrushTool::takeBack()
{
    const bool wasStroking = std::exchange(isStroking_, false);
    if (wasStroking) {
        emit strokeEnded();   // makes the partial stroke one undo step
    }
    return wasStroking;
}

void MaskBrushTool::paint(QPainter& painter, SliceView& view) const
{
    if (under_ != &view) {
        return;
    }
    const double radiusPx = radiusMm_ * view.pxPerMm();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(toQColor(tones().canvas, 0.7), 3.0));
    painter.drawEllipse(pointer_, radiusPx, radiusPx);
    const bool erases = (isStroking_ ? now_ : aim_) == MaskAim::Erase;   // erasing is shown by dashes as well as color
    painter.setPen(
        QPen(toQColor(erases ? tones().attention : tones().accent), 1.5, erases ? Qt::DashLine : Qt::SolidLine));
    painter.drawEllipse(pointer_, radiusPx, radiusPx);
    painter.restore();
}

QString MaskCutTool::caption() const
{
    return tr("Scissors: draw around the region to remove · Shift keeps the inside");
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
    if (!outline_.empty() &&
        (pointer.pointInPatient - outline_.back()).norm() * pointer.view.pxPerMm() >= smallestStepPx) {
        outline_.push_back(pointer.pointInPatient);
        lookAgain();
    }
}

void MaskCutTool::finishDrag(const SlicePointer& pointer)
{
    const std::vector<Eigen::Vector3d> outline = std::exchange(outline_, {});
    lookAgain();
    if (outline.size() < fewestCorners) {
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

bool MaskCutTool::takeBack()
{
    const bool isDrawn = !outline_.empty();
    end();
    lookAgain();
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
    painter.setPen(QPen(toQColor(tones().attention), 1.5, Qt::DashLine));
    painter.setBrush(toQColor(tones().attention, 0.12));
    painter.drawPolygon(shown);
    painter.restore();
}

}   // namespace angiopose::ui
