#include "ui/slices/path_tool.h"

#include "ui/slices/slice_model.h"
#include "ui/slices/slice_view.h"
#include "ui/theme/active_theme.h"

#include <QPainter>

#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr double endRadiusPx = 5.0;
constexpr double pathWidthPx = 2.0;
constexpr double visibleSlices = 1.5;   // in slice spacings; points farther away are drawn fainter
constexpr double faintPathOpacity = 0.35;

}   // namespace

PathTool::PathTool(SliceModel& model) : SliceTool(model)
{
    connect(&model, &SliceModel::scanChanged, this, &PathTool::drop);
}

QString PathTool::caption() const
{
    return from_ ? tr("One vessel: click its end point · Esc starts over")
                 : tr("One vessel: click its start point, then its end point");
}

void PathTool::showPath(std::vector<Eigen::Vector3d> pointsInPatient)
{
    if (from_) {
        path_ = std::move(pointsInPatient);
        requestRepaint();
    }
}

bool PathTool::click(const SlicePointer& pointer)
{
    if (!from_) {
        from_ = pointer.pointInPatient;
        emit pathReset();
    } else {
        const Eigen::Vector3d from = *from_;
        drop();
        emit endsPicked(from, pointer.pointInPatient);
    }
    requestRepaint();
    return true;
}

void PathTool::hover(const SlicePointer& pointer)
{
    if (from_) {
        emit pathRequested(*from_, pointer.pointInPatient);
    }
}

void PathTool::leave()
{
    path_.clear();
    requestRepaint();
}

bool PathTool::undoStep()
{
    const bool hadBegun = from_.has_value();
    drop();
    return hadBegun;
}

void PathTool::drop()
{
    from_.reset();
    path_.clear();
    emit pathReset();
    requestRepaint();
}

void PathTool::paint(QPainter& painter, SliceView& view) const
{
    if (!from_) {
        return;
    }
    const core::SliceGrid& grid = view.grid();
    const auto isNear = [&grid](const Eigen::Vector3d& point) {
        return std::abs(grid.distanceMm(point)) <= visibleSlices * grid.thicknessMm;
    };
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (std::size_t n = 1; n < path_.size(); ++n) {
        const bool isHere = isNear(path_[n]) || isNear(path_[n - 1]);
        painter.setPen(QPen(toQColor(colors().attention, isHere ? 1.0 : faintPathOpacity), pathWidthPx, Qt::SolidLine,
                            Qt::RoundCap));
        painter.drawLine(view.widgetFromPatient(path_[n - 1]), view.widgetFromPatient(path_[n]));
    }
    painter.setPen(QPen(toQColor(colors().attention, isNear(*from_) ? 1.0 : faintPathOpacity), pathWidthPx));
    painter.drawEllipse(view.widgetFromPatient(*from_), endRadiusPx, endRadiusPx);
    painter.restore();
}

}   // namespace angiopose::ui
