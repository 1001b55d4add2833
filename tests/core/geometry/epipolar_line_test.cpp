#include "core/geometry/epipolar_line.h"

#include "core/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

/// A camera at `angleDeg` about the patient's long axis, 750 mm from the origin, as with C-arms.
PosedCamera sightAt(double angleDeg, double fx = -2200.0)
{
    PosedCamera posedCamera{{fx, 2150.0, 250.0, 260.0, 512, 500}, {}};
    posedCamera.cameraFromPatient.rotation = expSo3({0.1, angleDeg * 0.0174532925199433, -0.05});
    posedCamera.cameraFromPatient.translation = {8.0, -5.0, 750.0};
    return posedCamera;
}

Eigen::Vector2d pixelOf(const PosedCamera& posedCamera, const Eigen::Vector3d& pointInPatient)
{
    return project(posedCamera.camera, posedCamera.cameraFromPatient * pointInPatient).value();
}

double distanceToSegment(const ImageSegment& segment, const Eigen::Vector2d& point)
{
    const Eigen::Vector2d way = segment.endPx - segment.beginPx;
    const double t = std::clamp(way.dot(point - segment.beginPx) / way.squaredNorm(), 0.0, 1.0);
    return (segment.beginPx + t * way - point).norm();
}

TEST(EpipolarLine, PassesThroughThePointThatIsSeenInBoth)
{
    CounterRandom random(3);
    int seen = 0;
    for (const double angleDeg : {-120.0, -35.0, 4.0, 60.0, 90.0, 175.0}) {
        for (int k = 0; k < 40; ++k) {
            const PosedCamera first = sightAt(0.0);
            const PosedCamera other = sightAt(angleDeg, k % 2 == 0 ? -2200.0 : 2200.0);
            Eigen::Vector3d point;
            for (double& coordinate : point) {
                coordinate = random.uniform(-80.0, 80.0);
            }
            const Eigen::Vector2d expected = pixelOf(other, point);
            const bool isInside =
                expected.x() >= -0.5 && expected.x() <= 511.5 && expected.y() >= -0.5 && expected.y() <= 499.5;
            const auto line = epipolarLine(first, pixelOf(first, point), other);
            if (isInside) {
                ++seen;
                ASSERT_TRUE(line) << angleDeg;
                EXPECT_LT(distanceToSegment(*line, expected), 1e-6) << angleDeg << ": " << point.transpose();
            }
        }
    }
    EXPECT_GT(seen, 150);
}

/// Compares with the textbook formula x'ᵀ F x = 0 with F = K'⁻ᵀ [t]× R K⁻¹.
TEST(EpipolarLine, IsThatOfTheFundamentalMatrix)
{
    const PosedCamera first = sightAt(0.0);
    const PosedCamera other = sightAt(70.0);
    const auto inverseOf = [](const ProjectionCamera& camera) {
        Eigen::Matrix3d k;
        k << camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0;
        return Eigen::Matrix3d(k.inverse());
    };
    const RigidTransform motion = other.cameraFromPatient * first.cameraFromPatient.inverse();
    const Eigen::Matrix3d fundamental =
        inverseOf(other.camera).transpose() * skew(motion.translation) * motion.rotation * inverseOf(first.camera);
    const Eigen::Vector2d pixel(301.0, 190.0);
    const Eigen::Vector3d line = fundamental * pixel.homogeneous();
    const auto segment = epipolarLine(first, pixel, other);
    ASSERT_TRUE(segment);
    for (const Eigen::Vector2d& end : {segment->beginPx, segment->endPx}) {
        EXPECT_LT(std::abs(line.dot(end.homogeneous())) / line.head<2>().norm(), 1e-8);
    }
}

TEST(EpipolarLine, EndsAtTheEdgesOfTheImageAndBeginsOnTheSideOfTheSource)
{
    const PosedCamera first = sightAt(0.0);
    const PosedCamera other = sightAt(90.0);
    const auto line = epipolarLine(first, {250.0, 260.0}, other);
    ASSERT_TRUE(line);
    for (const Eigen::Vector2d& end : {line->beginPx, line->endPx}) {
        const double edge = std::min({end.x() + 0.5, 511.5 - end.x(), end.y() + 0.5, 499.5 - end.y()});
        EXPECT_NEAR(edge, 0.0, 1e-6) << end.transpose();
    }
    const Eigen::Vector3d nearSource = first.cameraFromPatient.inverse() * Eigen::Vector3d(0.0, 0.0, 720.0);
    const Eigen::Vector3d nearDetector = first.cameraFromPatient.inverse() * Eigen::Vector3d(0.0, 0.0, 780.0);
    const auto fromBegin = [&](const Eigen::Vector3d& point) { return (pixelOf(other, point) - line->beginPx).norm(); };
    EXPECT_LT(fromBegin(nearSource), fromBegin(nearDetector));
}

TEST(EpipolarLine, IsAPointInTheImageItComesFrom)
{
    const PosedCamera posedCamera = sightAt(20.0);
    const auto line = epipolarLine(posedCamera, {100.0, 400.0}, posedCamera);
    ASSERT_TRUE(line);
    EXPECT_LT((line->beginPx - Eigen::Vector2d(100.0, 400.0)).norm(), 1e-6);
    EXPECT_LT((line->endPx - Eigen::Vector2d(100.0, 400.0)).norm(), 1e-6);
}

TEST(EpipolarLine, IsNothingBehindTheSourceOrBesideTheImage)
{
    const PosedCamera first = sightAt(0.0);
    PosedCamera turnedAway = sightAt(90.0);
    turnedAway.cameraFromPatient.translation.z() = -2000.0;
    EXPECT_FALSE(epipolarLine(first, {250.0, 260.0}, turnedAway));
    PosedCamera aside = sightAt(90.0);
    aside.cameraFromPatient.translation.y() = 900.0;
    EXPECT_FALSE(epipolarLine(first, {250.0, 260.0}, aside));
    PosedCamera unusable = sightAt(90.0);
    unusable.camera.fx = 0.0;
    EXPECT_FALSE(epipolarLine(first, {250.0, 260.0}, unusable));
    EXPECT_FALSE(epipolarLine(unusable, {250.0, 260.0}, first));
}

}   // namespace
}   // namespace angiopose::core
