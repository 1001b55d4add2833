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
constexpr double wayWidthPx = 2.0;
constexpr double nearSlices = 1.5;   // in slice thicknesses; more distant points are drawn fainter
constexpr double faintWay = 0.35;

}   // namespace

PathTool::PathTool(SliceModel& model) : SliceTool(model)
{
    connect(&model, &SliceModel::scanChanged, this, &PathTool::drop);
}

QString PathTool::caption() const
{
    return from_ ? tr("One vessel: click its end · Esc starts over") : tr("One vessel: click its start, then its end");
}

void PathTool::showWay(std::vector<Eigen::Vector3d> pointsInPatient)
{
    if (from_) {
        way_ = std::move(pointsInPatient);
        lookAgain();
    }
}

bool PathTool::click(const SlicePointer& pointer)
{
    if (!from_) {
        from_ = pointer.pointInPatient;
        emit begun();
    } else {
        const Eigen::Vector3d from = *from_;
        drop();
        emit chosen(from, pointer.pointInPatient);
    }
    lookAgain();
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
    way_.clear();
    lookAgain();
}

bool PathTool::takeBack()
{
    const bool hadBegun = from_.has_value();
    drop();
    return hadBegun;
}

void PathTool::drop()
{
    from_.reset();
    way_.clear();
    emit begun();
    lookAgain();
}

void PathTool::paint(QPainter& painter, SliceView& view) const
{
    if (!from_) {
        return;
    }
    const core::SliceGrid& grid = view.grid();
    const auto isNear = [&grid](const Eigen::Vector3d& point) {
        return std::abs(grid.distanceMm(point)) <= nearSlices * grid.thicknessMm;
    };
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (std::size_t n = 1; n < way_.size(); ++n) {
        const bool isHere = isNear(way_[n]) || isNear(way_[n - 1]);
        painter.setPen(
            QPen(toQColor(tones().attention, isHere ? 1.0 : faintWay), wayWidthPx, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(view.widgetFromPatient(way_[n - 1]), view.widgetFromPatient(way_[n]));
    }
    painter.setPen(QPen(toQColor(tones().attention, isNear(*from_) ? 1.0 : faintWay), wayWidthPx));
    painter.drawEllipse(view.widgetFromPatient(*from_), endRadiusPx, endRadiusPx);
    painter.restore();
}

}   // namespace angiopose::ui
