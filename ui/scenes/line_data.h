#pragma once

#include "ui/theme/theme.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <Eigen/Core>

#include <array>
#include <vector>

namespace angiopose::ui {

/// A point of a line in space, mm.
struct LinePoint {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();   ///< of the vessel; its edges lie at right angles to it
    double radiusMm = 0.0;
    Color tone;
    std::array<float, 3> wayPx{};   ///< image px from the line's begin along left edge, centre, right edge: for dashes
};

struct LineLook {
    double widthFactor = 1.0;
    double opacity = 1.0;
    bool isDashed = false;
    bool hasEndDots = false;
    bool hasEdges = false;   ///< radii are known: it can be shown by its two edges
};

/// Lines in space as VTK's poly data. Every point also carries its neighbours, so that a shader can join the pieces
/// wherever a camera puts them: the data do not change with the pose or the zoom.
class LineData {
public:
    LineData();
    void clear();
    void add(const std::vector<LinePoint>& line, const LineLook& look);
    void commit();   ///< after the last line: what was added is shown
    vtkPolyData* polyData() { return polyData_; }
    bool isEmpty() const { return points_->GetNumberOfPoints() == 0; }

    /// The arrays that a shader reads as attributes of the same names.
    static const std::array<const char*, 9>& attributes();

private:
    void addNeighbor(vtkFloatArray& place, vtkFloatArray& direction, const LinePoint* neighbor);

    vtkNew<vtkPolyData> polyData_;
    vtkNew<vtkPoints> points_;
    vtkNew<vtkCellArray> cells_;
    std::array<vtkNew<vtkFloatArray>, 9> arrays_;
};

}   // namespace angiopose::ui
