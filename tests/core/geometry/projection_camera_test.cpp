#include "core/geometry/projection_camera.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

using namespace angiopose;

namespace {

using namespace core;

const ProjectionCamera offCenterCamera{-2281.0, 2200.0, 250.0, 260.0, 512, 512};

TEST(Project, PutsTheAxisOnThePrincipalPoint)
{
    EXPECT_TRUE(project(offCenterCamera, {0.0, 0.0, 800.0})->isApprox(Eigen::Vector2d(250.0, 260.0)));
}

TEST(Project, NegativeFocalLengthMirrorsTheColumns)
{
    const Eigen::Vector2d pixel = *project(offCenterCamera, {-10.0, 10.0, 1000.0});
    EXPECT_DOUBLE_EQ(pixel.x(), 250.0 + 22.81);
    EXPECT_DOUBLE_EQ(pixel.y(), 260.0 + 22.0);
}

TEST(Project, PointsBehindTheSourceHaveNoPixel)
{
    EXPECT_FALSE(project(offCenterCamera, {0.0, 0.0, -5.0}));
    EXPECT_FALSE(project(offCenterCamera, {0.0, 0.0, 0.0}));
    EXPECT_FALSE(project(offCenterCamera, {0.0, 0.0, std::numeric_limits<double>::quiet_NaN()}));
}

TEST(Project, JacobianMatchesFiniteDifferences)
{
    for (const double sign : {-1.0, 1.0}) {
        ProjectionCamera camera = offCenterCamera;
        camera.fx *= sign;
        const Eigen::Vector3d point(31.0, -47.0, 733.0);
        const auto analytic = projectionJacobian(camera, point);
        for (int k = 0; k < 3; ++k) {
            Eigen::Vector3d step = Eigen::Vector3d::Zero();
            step(k) = 1e-3;
            const Eigen::Vector2d numeric = (*project(camera, point + step) - *project(camera, point - step)) / 2e-3;
            EXPECT_LT((numeric - analytic.col(k)).norm(), 1e-8);
        }
    }
}

TEST(Project, RayThroughAPixelPassesThePointThatProjectsThere)
{
    const Eigen::Vector3d point(31.0, -47.0, 733.0);
    const Eigen::Vector3d ray = rayThroughPixel(offCenterCamera, *project(offCenterCamera, point));
    EXPECT_LT(ray.cross(point.normalized()).norm(), 1e-12);
    EXPECT_GT(ray.z(), 0.0);
}

TEST(ProjectionCamera, UnusableCamerasAreNamed)
{
    EXPECT_FALSE(findProblem(offCenterCamera));
    ProjectionCamera noFocus = offCenterCamera;
    noFocus.fx = 0.0;
    EXPECT_NE(findProblem(noFocus)->text().find("fx"), std::string::npos);
    ProjectionCamera noSize = offCenterCamera;
    noSize.width = 0;
    EXPECT_NE(findProblem(noSize)->text().find("width"), std::string::npos);
}

}   // namespace
