#include "ui/scenes/tree_tubes.h"

#include "core/vessel/polyline.h"
#include "ui/scenes/branch_style.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr const char* radiusName = "radius";
constexpr const char* toneName = "tone";

/// Lines with a radius and a color for each point, which the tube filter takes as input.
struct TubeLines {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkDoubleArray> radius;
    vtkNew<vtkUnsignedCharArray> tone;

    TubeLines()
    {
        radius->SetName(radiusName);
        tone->SetName(toneName);
        tone->SetNumberOfComponents(3);
    }

    void addCell(const std::vector<Eigen::Vector3d>& line, const std::vector<double>& radiusMm, const Color& color)
    {
        cells->InsertNextCell(static_cast<int>(line.size()));
        for (std::size_t i = 0; i < line.size(); ++i) {
            cells->InsertCellPoint(points->InsertNextPoint(line[i].data()));
            radius->InsertNextValue(radiusMm[i]);
            tone->InsertNextTuple3(color.red, color.green, color.blue);
        }
    }
};

/// Adds a line as dashes, with gaps as long as the dashes.
void addDashes(TubeLines& lines, const std::vector<Eigen::Vector3d>& line, const std::vector<double>& radiusMm,
               const Color& color)
{
    constexpr std::size_t dash = 3;
    for (std::size_t i = 0; i + 1 < line.size(); i += 2 * dash) {
        const auto first = static_cast<std::ptrdiff_t>(i);
        const auto last = static_cast<std::ptrdiff_t>(std::min(line.size(), i + dash + 1));
        lines.addCell({line.begin() + first, line.begin() + last}, {radiusMm.begin() + first, radiusMm.begin() + last},
                      color);
    }
}

void addBranch(TubeLines& lines, const core::VesselBranch& branch, const BranchMarks& marks, const Palette& colors,
               double extent)
{
    if (branch.pointsInPatient.size() < 2) {
        return;
    }
    const BranchStyle style = branchStyle(branch.id, marks, colors);
    const double minRadiusMm = 0.0055 * extent;   // minimum radius: thinner tubes would break up into separate pixels
    const auto stations = core::evenStations<3>(branch.pointsInPatient, 0.008 * extent);
    const std::vector<Eigen::Vector3d> line = core::interpolate(branch.pointsInPatient, stations);
    std::vector<double> radiusMm(line.size(), minRadiusMm);
    if (!branch.radiusMm.empty()) {
        radiusMm = core::interpolate(branch.radiusMm, stations);
    }
    for (double& radius : radiusMm) {
        radius = style.widthFactor * std::clamp(radius, minRadiusMm, 0.02 * extent);
    }
    if (style.pattern == LinePattern::Dashed) {
        addDashes(lines, line, radiusMm, style.color);
    } else {
        lines.addCell(line, radiusMm, style.color);
    }
}

}   // namespace

TreeTubes::TreeTubes()
{
    tubes_->SetInputData(lines_);
    tubes_->SetNumberOfSides(10);
    tubes_->SetVaryRadiusToVaryRadiusByAbsoluteScalar();
    tubes_->CappingOn();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(tubes_->GetOutputPort());
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectColorArray(toneName);
    actor_->SetMapper(mapper);
    actor_->GetProperty()->SetAmbient(0.35);
    actor_->GetProperty()->SetDiffuse(0.7);
    actor_->GetProperty()->SetSpecular(0.15);
    actor_->GetProperty()->SetSpecularPower(20.0);
    actor_->VisibilityOff();
}

void TreeTubes::show(const core::VesselTree& tree, const BranchMarks& marks, const Palette& colors)
{
    TubeLines lines;
    const double extent = std::max(1e-3, core::extentMm(tree));
    for (const core::VesselBranch& branch : tree.branches) {
        addBranch(lines, branch, marks, colors, extent);
    }
    lines_->SetPoints(lines.points);
    lines_->SetLines(lines.cells);
    lines_->GetPointData()->SetScalars(lines.radius);
    lines_->GetPointData()->AddArray(lines.tone);
    actor_->SetVisibility(lines.points->GetNumberOfPoints() > 0);
}

}   // namespace angiopose::ui
