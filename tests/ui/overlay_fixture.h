#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/imaging/image2d.h"
#include "core/vessel/vessel_tree.h"

#include <Eigen/Geometry>
#include <functional>
#include <vector>

namespace angiopose::test {

enum class Mirror { SeenFromDetector, SeenFromSource };

/// A decentered camera with unequal focal lengths; seen from the detector, its fx is negative.
inline core::ProjectionCamera obliqueCamera(Mirror mirror)
{
    const double sign = mirror == Mirror::SeenFromDetector ? -1.0 : 1.0;
    return {sign * 2400.0, 2300.0, 250.3, 260.8, 512, 512};
}

inline core::RigidTransform obliquePose()
{
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(-0.3, Eigen::Vector3d::UnitY()))
            .toRotationMatrix();
    return {turn, {3.0, -4.0, 750.0}};
}

/// Branches so short that each appears as one dot, far apart in the image.
inline core::VesselTree treeOfDots()
{
    core::VesselTree tree;
    int id = 1;
    for (const double x : {-40.0, -15.0, 12.0, 35.0}) {
        for (const double y : {-30.0, 5.0, 38.0}) {
            core::VesselBranch branch;
            branch.id = id++;
            const Eigen::Vector3d at(x, y, 0.3 * x - 0.2 * y);
            branch.pointsInPatient = {at, at + Eigen::Vector3d(1e-3, 0.0, 0.0)};
            tree.branches.push_back(branch);
        }
    }
    return tree;
}

/// Center of the light around `guess` (pixel centers at integers); `brightness(x, y)` gives each pixel.
inline Eigen::Vector2d centerOfLight(const std::function<double(int, int)>& brightness, const Eigen::Vector2d& guess)
{
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double weight = 0.0;
    const int reach = 9;
    const auto x0 = static_cast<int>(guess.x());
    const auto y0 = static_cast<int>(guess.y());
    for (int y = y0 - reach; y <= y0 + reach; ++y) {
        for (int x = x0 - reach; x <= x0 + reach; ++x) {
            const double light = brightness(x, y);
            sum += light * Eigen::Vector2d(x, y);
            weight += light;
        }
    }
    return weight > 0.0 ? Eigen::Vector2d(sum / weight) : Eigen::Vector2d(1e9, 1e9);
}

}   // namespace angiopose::test
