#include "app/texts/turned_vessels.h"

#include "core/geometry/angle_units.h"
#include "core/registration/pose/centroid_pose.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace angiopose::app {
namespace {

constexpr int sidePx = 512;
constexpr double filledPart = 0.86;   // of the picture, by the sphere that holds the vessels
constexpr double distanceInRadii = 6.0;   // from where they are seen: as deep as in an angiogram

/// Eye in front of the patient: left of the patient on the right, head up, depth to the back (LPS).
Eigen::Matrix3d fromFront()
{
    return (Eigen::Matrix3d() << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0).finished();
}

/// Of the box around the vessels, so that they fill the picture.
Eigen::Vector3d middleOf(const core::VesselTree& tree)
{
    Eigen::AlignedBox3d box;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            box.extend(point);
        }
    }
    return box.isEmpty() ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : box.center();
}

double radiusMm(const core::VesselTree& tree, const Eigen::Vector3d& centre)
{
    double radius = 1.0;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            radius = std::max(radius, (point - centre).norm());
        }
    }
    return radius;
}

core::ProjectionCamera cameraAround(double radius)
{
    const double distance = distanceInRadii * radius;
    const double pxPerSlope = 0.5 * filledPart * sidePx * (distance - radius) / radius;
    const double middle = 0.5 * (sidePx - 1);
    return {pxPerSlope, pxPerSlope, middle, middle, sidePx, sidePx};
}

}   // namespace

core::Case vesselsAlone(const core::Case& theCase, VesselShape shape)
{
    core::Case alone = theCase;
    const core::View& shown = theCase.shown();
    const core::VesselTree tree = drawnVessels(shown, theCase.vessels, shown.cameraFromPatient, shape).tree;
    core::Angiogram ground;
    ground.frames = {core::ImageF(sidePx, sidePx, 0.0F)};
    if (shown.angiogram) {
        ground.identity = shown.angiogram->identity;
    }
    core::View view;
    view.imageFile = shown.imageFile;
    view.angiogram = std::make_shared<const core::Angiogram>(std::move(ground));
    view.geometry.cameraOverride = cameraAround(radiusMm(tree, middleOf(tree)));
    alone.vessels.tree = std::make_shared<const core::VesselTree>(tree);
    alone.shown() = view;
    return turnedBy(std::move(alone), 0.0);
}

core::Case turnedBy(core::Case alone, double degrees)
{
    const core::VesselTree& tree = *alone.vessels.tree;
    const Eigen::Vector3d centre = middleOf(tree);
    const Eigen::AngleAxisd turn(degrees / core::degreesPerRadian, Eigen::Vector3d::UnitZ());
    const Eigen::Matrix3d rotation = fromFront() * turn.toRotationMatrix();
    const Eigen::Vector3d inFront(0.0, 0.0, distanceInRadii * radiusMm(tree, centre));
    alone.shown().cameraFromPatient = core::cameraFromPatient(core::CentroidPose{rotation, inFront}, centre);
    return alone;
}

}   // namespace angiopose::app
