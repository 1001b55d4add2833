#include "core/simulation/fit_pose_to_correspondences.h"

#include "core/simulation/simulated_case.h"
#include "tests/support/matchers.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

TEST(FitKnownPose, RecoversThePoseFromExactPixels)
{
    const ProjectionCamera camera{-1877.0, 1877.0, 255.5, 255.5, 512, 512};
    const VesselTree tree = simulateTree(4);
    const RigidTransform truth{expSo3({0.4, -0.2, 0.1}), {5.0, 3.0, 790.0}};
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector2d> pixels;
    for (const VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            points.push_back(point);
            pixels.push_back(*project(camera, truth * point));
        }
    }
    CounterRandom random(9);
    const RigidTransform start = perturbAboutCentroid(truth, centroidInPatient(tree), 3.0, 8.0, random);
    EXPECT_TRUE(test::nearPose(fitPoseToCorrespondences(points, pixels, camera, start), truth, 1e-7, 1e-7));
}

}   // namespace
