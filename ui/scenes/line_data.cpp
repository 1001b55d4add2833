#include "ui/scenes/line_data.h"

#include <vtkPointData.h>

namespace angiopose::ui {
namespace {

struct LineArray {
    enum Index { Here, Before, BeforeDirection, After, AfterDirection, Tone, Look, Way, WayEnd };
};
constexpr std::array<int, 9> componentsOfLineArray{4, 4, 3, 4, 3, 3, 4, 3, 3};

}   // namespace

const std::array<const char*, 9>& LineData::attributes()
{
    static const std::array<const char*, 9> names{
        "here", "before", "beforeDirection", "after", "afterDirection", "tone", "look", "way", "wayEnd"};
    return names;
}

LineData::LineData()
{
    points_->SetDataTypeToFloat();
    for (std::size_t i = 0; i < arrays_.size(); ++i) {
        arrays_[i]->SetName(attributes()[i]);
        arrays_[i]->SetNumberOfComponents(componentsOfLineArray[i]);
        polyData_->GetPointData()->AddArray(arrays_[i]);
    }
    polyData_->SetPoints(points_);
    polyData_->SetLines(cells_);
}

void LineData::clear()
{
    points_->Reset();
    cells_->Reset();
    for (const auto& array : arrays_) {
        array->Reset();
    }
}

void LineData::addNeighbor(vtkFloatArray& place, vtkFloatArray& direction, const LinePoint* neighbor)
{
    constexpr double none = -1.0;   // stored in place of the radius if there is no neighbor
    if (!neighbor) {
        place.InsertNextTuple4(0.0, 0.0, 0.0, none);
        direction.InsertNextTuple3(0.0, 0.0, 0.0);
        return;
    }
    const Eigen::Vector3d& at = neighbor->at;
    place.InsertNextTuple4(at.x(), at.y(), at.z(), neighbor->radiusMm);
    direction.InsertNextTuple3(neighbor->direction.x(), neighbor->direction.y(), neighbor->direction.z());
}

void LineData::add(const std::vector<LinePoint>& line, const LineStyle& style)
{
    if (line.size() < 2) {
        return;
    }
    cells_->InsertNextCell(static_cast<int>(line.size()));
    for (std::size_t i = 0; i < line.size(); ++i) {
        const LinePoint& point = line[i];
        cells_->InsertCellPoint(points_->InsertNextPoint(point.at.data()));
        arrays_[LineArray::Here]->InsertNextTuple4(point.direction.x(), point.direction.y(), point.direction.z(),
                                                   point.radiusMm);
        addNeighbor(*arrays_[LineArray::Before], *arrays_[LineArray::BeforeDirection], i > 0 ? &line[i - 1] : nullptr);
        addNeighbor(*arrays_[LineArray::After], *arrays_[LineArray::AfterDirection],
                    i + 1 < line.size() ? &line[i + 1] : nullptr);
        const std::array<double, 3> tone = point.tone.unit();
        arrays_[LineArray::Tone]->InsertNextTuple3(tone[0], tone[1], tone[2]);
        arrays_[LineArray::Look]->InsertNextTuple4(style.widthFactor, style.opacity, style.isDashed ? 1.0 : 0.0,
                                                   (style.hasEndDots ? 1.0 : 0.0) + (style.hasEdges ? 2.0 : 0.0));
        arrays_[LineArray::Way]->InsertNextTuple3(point.arcLengthPx[0], point.arcLengthPx[1], point.arcLengthPx[2]);
        const std::array<float, 3>& end = line.back().arcLengthPx;
        arrays_[LineArray::WayEnd]->InsertNextTuple3(end[0], end[1], end[2]);
    }
}

void LineData::commit()
{
    points_->Modified();
    cells_->Modified();
    for (const auto& array : arrays_) {
        array->Modified();
    }
    polyData_->Modified();
}

}   // namespace angiopose::ui
