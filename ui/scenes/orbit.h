#pragma once

#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <array>

class vtkCamera;

namespace angiopose::ui {

struct Beam;

/// Maps patient mm to device px (origin at the bottom left) in a parallel projection.
struct ScreenFromPatient {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();   ///< rows point right, up, toward the viewer
    Eigen::Vector3d focalPoint = Eigen::Vector3d::Zero();
    Eigen::Vector2d centerPx = Eigen::Vector2d::Zero();
    double pxPerMm = 1.0;

    Eigen::Vector2d operator*(const Eigen::Vector3d& point) const
    {
        return centerPx + pxPerMm * (rotation * (point - focalPoint)).head<2>();
    }
    Eigen::Vector3d rotate(const Eigen::Vector3d& direction) const { return rotation * direction; }
};

ScreenFromPatient screenFromPatient(vtkCamera& camera, int width, int height);

/// Content to which a view is framed: beam and tree, or only the tree.
enum class ViewExtent { Everything, Vessels };

/// Points a parallel camera at beam and tree from behind the detector, so that left and right match the angiogram; the
/// source is at the top, and the extent fits a view with this aspect ratio (width/height).
void frameBeam(vtkCamera& camera, const Beam& beam, const core::VesselTree& tree, double aspect,
               ViewExtent extent = ViewExtent::Everything);

/// Translates the camera in its view plane by a mouse movement, so that the scene follows the pointer.
void pan(vtkCamera& camera, int heightPx, double rightPx, double upPx);

/// Returns the scene bounds in VTK order (x min, x max, y min, …).
std::array<double, 6> sceneBounds(const Beam& beam, const core::VesselTree& tree);

}   // namespace angiopose::ui
