#include "ui/scenes/pinhole_view.h"

#include <vtkCamera.h>

#include <cmath>
#include <numbers>

namespace angiopose::ui {

void setPinhole(vtkCamera& view, const core::ProjectionCamera& camera, const core::RigidTransform& cameraFromPatient,
                const ViewRect& rect)
{
    const Eigen::Matrix3d& rotation = cameraFromPatient.rotation;
    const Eigen::Vector3d source = -rotation.transpose() * cameraFromPatient.translation;
    const Eigen::Vector3d ahead = source + rotation.row(2).transpose();
    const Eigen::Vector3d up = -rotation.row(1).transpose();   // v counts down
    view.SetPosition(source.x(), source.y(), source.z());
    view.SetFocalPoint(ahead.x(), ahead.y(), ahead.z());
    view.SetViewUp(up.x(), up.y(), up.z());

    // Half of what is seen at depth 1, and its middle in halves beside the central ray; a mirrored image has fx > 0.
    const double halfWidth = 0.5 * rect.width();
    const double halfHeight = 0.5 * rect.height();
    view.SetViewAngle(2.0 * std::atan(halfHeight / camera.fy) * 180.0 / std::numbers::pi);
    view.UseExplicitAspectRatioOn();
    view.SetExplicitAspectRatio((halfWidth / camera.fx) / (halfHeight / camera.fy));
    view.SetWindowCenter((0.5 * (rect.left + rect.right) - camera.cx) / halfWidth,
                         (camera.cy - 0.5 * (rect.top + rect.bottom)) / halfHeight);
}

}   // namespace angiopose::ui
