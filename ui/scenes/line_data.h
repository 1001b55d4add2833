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

/// Point of a line in patient space, mm.
struct LinePoint {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();   ///< direction of the vessel, perpendicular to its edges
    double radiusMm = 0.0;
    Color tone;
    std::array<float, 3> arcLengthPx{};   ///< lengths from the start along left edge, center and right edge, image px
};

struct LineStyle {
    double widthFactor = 1.0;
    double opacity = 1.0;
    bool isDashed = false;
    bool hasEndDots = false;
    bool hasEdges = false;   ///< true if the radii are known, so that both edges can be drawn
};

/// Lines in space as VTK poly data. Every point also stores its neighbors, with which a shader joins the segments for
/// any camera; the data therefore do not depend on pose or zoom.
class LineData {
public:
    LineData();
    void clear();
    void add(const std::vector<LinePoint>& line, const LineStyle& style);
    void commit();   ///< publishes the data; call it after adding the last line
    vtkPolyData* polyData() { return polyData_; }
    bool isEmpty() const { return points_->GetNumberOfPoints() == 0; }

    /// Returns the names of the arrays that the shader reads as vertex attributes.
    static const std::array<const char*, 9>& attributes();

private:
    void addNeighbor(vtkFloatArray& place, vtkFloatArray& direction, const LinePoint* neighbor);

    vtkNew<vtkPolyData> polyData_;
    vtkNew<vtkPoints> points_;
    vtkNew<vtkCellArray> cells_;
    std::array<vtkNew<vtkFloatArray>, 9> arrays_;
};

}   // namespace angiopose::ui
