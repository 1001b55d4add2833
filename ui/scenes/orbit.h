#pragma once

#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <array>

class vtkCamera;

namespace angiopose::ui {

struct Beam;

/// Maps patient mm to device px (from the bottom left) of a parallel-projection view.
struct ScreenFromPatient {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();   ///< rows: right, up, towards the viewer
    Eigen::Vector3d focalPoint = Eigen::Vector3d::Zero();
    Eigen::Vector2d centerPx = Eigen::Vector2d::Zero();
    double pxPerMm = 1.0;

    Eigen::Vector2d operator*(const Eigen::Vector3d& point) const
    {
        return centerPx + pxPerMm * (rotation * (point - focalPoint)).head<2>();
    }
    Eigen::Vector3d turned(const Eigen::Vector3d& direction) const { return rotation * direction; }
};

ScreenFromPatient screenFromPatient(vtkCamera& camera, int width, int height);

/// Extent of a view: beam and tree, or only the tree.
enum class ViewExtent { Everything, Vessels };

/// Points a parallel camera at beam and tree from behind the detector, so left and right match the angiogram; source at
/// the top, the extent fitted to a view of this aspect ratio (width/height).
void frameBeam(vtkCamera& camera, const Beam& beam, const core::VesselTree& tree, double aspect,
               ViewExtent extent = ViewExtent::Everything);

/// Moves the camera in its own plane so that the scene follows the mouse.
void pan(vtkCamera& camera, int heightPx, double rightPx, double upPx);

/// Scene bounds in VTK order: x min, x max, y min, …
std::array<double, 6> sceneBounds(const Beam& beam, const core::VesselTree& tree);

}   // namespace angiopose::ui