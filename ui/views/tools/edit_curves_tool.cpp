#include "ui/views/tools/edit_curves_tool.h"

#include "core/tracing/angiogram/drawing/edit_centerline.h"
#include "ui/views/angiogram_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr double reachOnScreenPx = 9.0;
constexpr double minBrushPx = 4.0;
constexpr double maxBrushPx = 80.0;

bool isSame(const core::Centerline2d& a, const core::Centerline2d& b)
{
    return a.pointCount() == b.pointCount() && a.curves.size() == b.curves.size();
}

bool isStraight(const ToolPoint& point)
{
    return point.modifiers.testFlag(Qt::ShiftModifier);
}

}   // namespace

EditCurvesTool::EditCurvesTool(AngiogramView& view) : ImageTool(view) {}

EditCurvesTool::~EditCurvesTool() = default;

void EditCurvesTool::showCurves(const core::Centerline2d& curves, CurveMarks marks)
{
    curves_ = curves;
    setShown(curves);
    marks_ = std::move(marks);
    if (std::ranges::find(marks_.suspects, chosenSuspect_) == marks_.suspects.end()) {
        chosenSuspect_ = -1;
    }
    hovered_ = -1;
    region_.clear();
    view().redraw();
}

void EditCurvesTool::setShown(core::Centerline2d curves)
{
    shownCurves_ = std::move(curves);
    ++shownRevision_;
}

void EditCurvesTool::setReady(bool ready)
{
    isReady_ = ready;
    view().redraw();
}

void EditCurvesTool::setGuide(std::shared_ptr<CurveGuide> guide)
{
    guide_ = std::move(guide);
    path_.clear();
}

void EditCurvesTool::setEdit(CurveEdit edit)
{
    if (edit != edit_) {
        path_.clear();
        edit_ = edit;
        view().redraw();
        emit editChanged(edit);
    }
}

void EditCurvesTool::setBrush(double radius)
{
    brushRadius_ = std::clamp(radius, minBrushPx, maxBrushPx);
    view().redraw();
}

QString EditCurvesTool::caption() const
{
    if (!isReady_) {
        return tr("Edit vessels: tracing this frame…");
    }
    if (chosenSuspect_ >= 0) {
        return tr("Possible catheter: A keep as vessel, W mark as catheter or guidewire, Delete exclude, S next");
    }
    switch (edit_) {
        case CurveEdit::Erase:
            return tr("Erase: brush over curves, [ ] brush size, Esc ends");
        case CurveEdit::Draw:
            return tr(
                "Draw: click along the vessel, Enter ends, Backspace removes a point, Shift draws straight lines");
        case CurveEdit::Cut:
            return tr("Cut: click where to split a curve, Esc ends");
        case CurveEdit::Remove:
            return tr("Not a vessel: click a curve to exclude it, Esc ends");
        case CurveEdit::MarkDevice:
            return tr("Catheter or guidewire: click a curve to mark or unmark it as a device, Esc ends");
        case CurveEdit::Box:
            return tr("Box: drag around non-vessels; Ctrl keeps only the inside, Esc ends");
        case CurveEdit::Lasso:
            return tr("Lasso: draw around non-vessels; Ctrl keeps only the inside, Esc ends");
    }
    return {};
}

void EditCurvesTool::begin()
{
    emit activated();
}

void EditCurvesTool::end()
{
    path_.clear();
    region_.clear();
    pointer_.reset();
    hovered_ = chosenSuspect_ = -1;
}

double EditCurvesTool::reachPx() const
{
    return reachOnScreenPx / view().zoom();
}

void EditCurvesTool::report(const core::Centerline2d& curves, const LocalizedText& undoText)
{
    if (!isSame(curves, curves_)) {
        emit edited(curves, undoText);
    }
    setShown(curves_);   // the receiver of `edited` may have replaced the curves
    view().redraw();
}

void EditCurvesTool::eraseAlong(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    const double radiusPx = brushRadius_ / view().zoom();
    const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() / (0.5 * radiusPx))));
    core::Centerline2d left = shownCurves_;
    for (int k = 0; k <= steps; ++k) {
        left = core::eraseDisc(left, from + (to - from) * k / steps, radiusPx);
    }
    setShown(std::move(left));
}

bool EditCurvesTool::startDrag(const ToolPoint& pressed)
{
    const bool drags = edit_ == CurveEdit::Erase || edit_ == CurveEdit::Box || edit_ == CurveEdit::Lasso;
    if (!isReady_ || !drags) {
        return false;
    }
    isDragging_ = true;
    pointer_ = pressed;
    region_ = {pressed.imagePx};
    keepsInside_ = pressed.modifiers.testFlag(Qt::ControlModifier);
    hovered_ = -1;
    return true;
}

void EditCurvesTool::drag(const ToolPoint& point)
{
    if (!isDragging_) {
        return;   // new curves canceled the drag
    }
    if (edit_ == CurveEdit::Erase) {
        eraseAlong(pointer_ ? pointer_->imagePx : point.imagePx, point.imagePx);
    } else {
        region_.push_back(point.imagePx);
        setShown(keepsInside_ ? core::cropToPolygon(curves_, outline()) : core::erasePolygon(curves_, outline()));
    }
    pointer_ = point;
    view().redraw();
}

void EditCurvesTool::finishDrag(const ToolPoint&)
{
    if (!std::exchange(isDragging_, false)) {
        return;
    }
    const std::vector<Eigen::Vector2d> polygon = outline();
    region_.clear();
    if (edit_ == CurveEdit::Erase) {
        report(core::Centerline2d(shownCurves_), [] { return tr("Erase curves"); });
    } else if (keepsInside_) {
        report(core::cropToPolygon(curves_, polygon), [] { return tr("Restrict to a region"); });
    } else {
        report(core::erasePolygon(curves_, polygon), [] { return tr("Exclude a region"); });
    }
}

void EditCurvesTool::cancelDrag()
{
    isDragging_ = false;
    region_.clear();
    setShown(curves_);
}

bool EditCurvesTool::click(const ToolPoint& point)
{
    if (!isReady_ || clickSign(point)) {
        return true;
    }
    switch (edit_) {
        case CurveEdit::Erase:
            eraseAlong(point.imagePx, point.imagePx);
            report(core::Centerline2d(shownCurves_), [] { return tr("Erase curves"); });
            break;
        case CurveEdit::Draw:
            setAnchor(point);
            break;
        case CurveEdit::Cut:
            report(core::splitAt(curves_, point.imagePx, reachPx()), [] { return tr("Cut a curve"); });
            break;
        case CurveEdit::Remove:
            report(core::removeCurve(curves_, core::curveAt(curves_, point.imagePx, reachPx())),
                   [] { return tr("Mark as non-vessel"); });
            break;
        case CurveEdit::MarkDevice:
            markDevice(core::curveAt(curves_, point.imagePx, reachPx()));
            break;
        case CurveEdit::Box:
        case CurveEdit::Lasso:
            break;
    }
    return true;
}

void EditCurvesTool::setAnchor(const ToolPoint& point)
{
    path_.addAnchor(point.imagePx, guide_ ? &guide_->liveWire : nullptr, isStraight(point));
    view().redraw();
}

bool EditCurvesTool::doubleClick(const ToolPoint&)
{
    if (edit_ == CurveEdit::Draw) {
        finishPath();
    }
    return true;   // accepted, so that the view is not maximized
}

void EditCurvesTool::finishPath()
{
    const std::vector<Eigen::Vector2d> path = path_.points();
    path_.clear();
    report(guide_ ? core::addDrawnCurve(curves_, path, guide_->opacity, guide_->maxRadiusPx)
                  : core::addDrawnCurve(curves_, path),
           [] { return tr("Draw a curve"); });
}

void EditCurvesTool::hover(const ToolPoint& point)
{
    pointer_ = point;
    const bool picks =
        isReady_ && (edit_ == CurveEdit::Cut || edit_ == CurveEdit::Remove || edit_ == CurveEdit::MarkDevice);
    hovered_ = picks ? core::curveAt(curves_, point.imagePx, reachPx()) : -1;
    if (edit_ == CurveEdit::Draw && isReady_) {
        path_.previewTo(point.imagePx, guide_ ? &guide_->liveWire : nullptr, isStraight(point));
    }
    view().redraw();
}

void EditCurvesTool::leave()
{
    pointer_.reset();
    hovered_ = -1;
}

std::optional<QCursor> EditCurvesTool::cursor(bool) const
{
    if (!isReady_) {
        return QCursor(Qt::BusyCursor);
    }
    if (edit_ == CurveEdit::Erase) {
        return QCursor(Qt::BlankCursor);   // the brush outline replaces the cursor
    }
    return QCursor(hovered_ >= 0 ? Qt::PointingHandCursor : Qt::CrossCursor);
}

std::vector<Eigen::Vector2d> EditCurvesTool::outline() const
{
    if (edit_ != CurveEdit::Box || region_.size() < 2) {
        return region_;
    }
    const Eigen::Vector2d a = region_.front();
    const Eigen::Vector2d b = region_.back();
    return {a, {b.x(), a.y()}, b, {a.x(), b.y()}};
}

}   // namespace angiopose::ui
