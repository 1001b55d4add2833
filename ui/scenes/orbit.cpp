#include "ui/scenes/orbit.h"

#include "ui/scenes/beam.h"

#include <vtkCamera.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::ui {
namespace {

constexpr double tiltRad = 33.0 * std::numbers::pi / 180.0;   // angle between the viewing direction and the beam
constexpr double marginShare = 0.08;

Eigen::AlignedBox3d boxOf(const Beam& beam, const core::VesselTree& tree)
{
    Eigen::AlignedBox3d box;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            box.extend(point);
        }
    }
    if (beam.hasDetector()) {
        box.extend(beam.source());
        for (const Eigen::Vector3d& corner : beam.detectorCorners()) {
            box.extend(corner);
        }
    }
    return box;
}

/// Returns the points that a view of this extent must contain.
std::vector<Eigen::Vector3d> landmarks(const Beam& beam, const core::VesselTree& tree, ViewExtent extent)
{
    std::vector<Eigen::Vector3d> points;
    for (const core::VesselBranch& branch : tree.branches) {
        points.insert(points.end(), branch.pointsInPatient.begin(), branch.pointsInPatient.end());
    }
    if (beam.hasDetector() && extent == ViewExtent::Everything) {
        points.push_back(beam.source());
        const auto corners = beam.detectorCorners();
        points.insert(points.end(), corners.begin(), corners.end());
    }
    return points;
}

/// Viewing direction and up vector, both of unit length.
struct Look {
    Eigen::Vector3d viewDirection, up;
};

/// Default view without an image: anterior view of the patient, head up (LPS).
const Look fromTheFront{Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};

/// Returns the view from the upper edge of the detector, with the X-ray source at the top.
Look acrossBeam(const Beam& beam)
{
    const Eigen::Vector3d along = beam.patientFromCamera.rotation.col(2);
    const Eigen::Vector3d imageDown = std::copysign(1.0, beam.camera.fy) * beam.patientFromCamera.rotation.col(1);
    const Eigen::Vector3d viewDirection = (-std::cos(tiltRad) * along + std::sin(tiltRad) * imageDown).normalized();
    return {viewDirection, (-along + along.dot(viewDirection) * viewDirection).normalized()};
}

}   // namespace

ScreenFromPatient screenFromPatient(vtkCamera& camera, int width, int height)
{
    ScreenFromPatient screen;
    const Eigen::Vector3d position(camera.GetPosition());
    screen.focalPoint = Eigen::Vector3d(camera.GetFocalPoint());
    const Eigen::Vector3d toViewer = (position - screen.focalPoint).normalized();
    const Eigen::Vector3d right = Eigen::Vector3d(camera.GetViewUp()).cross(toViewer).normalized();
    screen.rotation << right.transpose(), toViewer.cross(right).transpose(), toViewer.transpose();
    screen.centerPx = 0.5 * Eigen::Vector2d(width, height);
    screen.pxPerMm = 0.5 * height / camera.GetParallelScale();
    return screen;
}

void frameBeam(vtkCamera& camera, const Beam& beam, const core::VesselTree& tree, double aspect, ViewExtent extent)
{
    const auto [viewDirection, up] = beam.hasDetector() ? acrossBeam(beam) : fromTheFront;
    const Eigen::Vector3d right = viewDirection.cross(up);

    const Eigen::Vector3d pivot = core::centroidInPatient(tree);
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector3d& point : landmarks(beam, tree, extent)) {
        box.extend(Eigen::Vector2d(right.dot(point - pivot), up.dot(point - pivot)));
    }
    const Eigen::Vector3d center = pivot + box.center().x() * right + box.center().y() * up;
    const double half = 0.5 * std::max(box.sizes().y(), box.sizes().x() / aspect) * (1.0 + 2.0 * marginShare);
    const Eigen::Vector3d position = center - 4.0 * half * viewDirection;
    camera.ParallelProjectionOn();
    camera.SetParallelScale(std::max(half, 1e-3));
    camera.SetFocalPoint(center.x(), center.y(), center.z());
    camera.SetPosition(position.x(), position.y(), position.z());
    camera.SetViewUp(up.x(), up.y(), up.z());
}

void pan(vtkCamera& camera, int heightPx, double rightPx, double upPx)
{
    const ScreenFromPatient screen = screenFromPatient(camera, 1, heightPx);
    const Eigen::Vector3d shift =
        -(rightPx * screen.rotation.row(0) + upPx * screen.rotation.row(1)).transpose() / screen.pxPerMm;
    const Eigen::Vector3d focalPoint = Eigen::Vector3d(camera.GetFocalPoint()) + shift;
    const Eigen::Vector3d position = Eigen::Vector3d(camera.GetPosition()) + shift;
    camera.SetFocalPoint(focalPoint.x(), focalPoint.y(), focalPoint.z());
    camera.SetPosition(position.x(), position.y(), position.z());
}

std::array<double, 6> sceneBounds(const Beam& beam, const core::VesselTree& tree)
{
    const Eigen::AlignedBox3d box = boxOf(beam, tree);
    if (box.isEmpty()) {
        return {-1.0, 1.0, -1.0, 1.0, -1.0, 1.0};
    }
    const Eigen::Vector3d& a = box.min();
    const Eigen::Vector3d& b = box.max();
    return {a.x(), b.x(), a.y(), b.y(), a.z(), b.z()};
}

}   // namespace angiopose::ui
