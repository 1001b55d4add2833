#include "core/registration/pose/pose_freedom.h"

#include "core/geometry/projection_camera.h"
#include "core/support/random.h"

#include "core/geometry/angle_units.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

PoseLocks locksOf(std::initializer_list<PoseAxis> axes)
{
    PoseLocks locks{};
    for (const PoseAxis axis : axes) {
        locks[static_cast<std::size_t>(axis)] = true;
    }
    return locks;
}

/// A pose rotated and shifted from a reference pose, with the pivot off the centroid.
struct Scene {
    CentroidPose start{expSo3({0.1, -0.2, 0.05}) * expSo3({0.4, 0.9, -0.3}), {5.0, -8.0, 790.0}};
    PoseFreedom::Frame frame{expSo3({0.4, 0.9, -0.3}), {6.0, -4.0, 9.0}};

    PoseFreedom freedom(std::initializer_list<PoseAxis> axes) const { return {locksOf(axes), frame, start}; }
    Vector6d randomStep(CounterRandom& random) const
    {
        Vector6d step;
        for (double& value : step) {
            value = random.normal();
        }
        step.head<3>() *= 3.0 * radiansPerDegree;
        return 4.0 * step;
    }
};

TEST(PoseFreedom, CoordinatesTellThePose)
{
    const Scene scene;
    const PoseFreedom freedom = scene.freedom({PoseAxis::AlongRay});
    const CentroidPose back = freedom.poseAt(freedom.coordinates(scene.start));
    EXPECT_LT((back.rotation - scene.start.rotation).norm(), 1e-14);
    EXPECT_LT((back.centroidInCamera - scene.start.centroidInCamera).norm(), 1e-11);
}

TEST(PoseFreedom, CoordinatesAreThoseOfThePosePanel)
{
    const Scene scene;
    const Eigen::Vector3d centroid(100.0, -50.0, 30.0);
    const ProjectionCamera camera{-1877.0, 1877.0, 255.5, 255.5, 512, 512};
    const CentroidPose referencePose{scene.frame.reference, {1.0, 2.0, 800.0}};
    const PoseOffset offset =
        offsetBetween(cameraFromPatient(referencePose, centroid), cameraFromPatient(scene.start, centroid),
                      centroid + scene.frame.pivotFromCentroid, camera);
    const PoseFreedom freedom = scene.freedom({PoseAxis::AlongRay});
    const Vector6d difference = freedom.coordinates(scene.start) - freedom.coordinates(referencePose);
    EXPECT_NEAR(difference[0] / radiansPerDegree, -offset.craCauDeg, 1e-10);
    EXPECT_NEAR(difference[1] / radiansPerDegree, offset.laoRaoDeg, 1e-10);
    EXPECT_NEAR(difference[2] / radiansPerDegree, -offset.rollDeg, 1e-10);   // the image is mirrored
    EXPECT_NEAR(difference[3], -offset.rightMm, 1e-10);
    EXPECT_NEAR(difference[4], -offset.upMm, 1e-10);
    EXPECT_NEAR(difference[5], offset.alongRayMm, 1e-10);
}

TEST(PoseFreedom, StepsPerCoordinateMatchDifferences)
{
    const Scene scene;
    const PoseFreedom freedom = scene.freedom({PoseAxis::Right});
    const Matrix6d steps = freedom.stepsPerCoordinate(scene.start);
    const Vector6d at = freedom.coordinates(scene.start);
    for (int k = 0; k < 6; ++k) {
        const double h = 1e-5;
        const Vector6d difference =
            stepBetween(freedom.poseAt(at - h * Vector6d::Unit(k)), freedom.poseAt(at + h * Vector6d::Unit(k))) /
            (2.0 * h);
        EXPECT_LT((difference - steps.col(k)).norm(), 1e-6) << k;
    }
}

TEST(PoseFreedom, FreeStepsAndHeldPosesKeepWhatIsLocked)
{
    const Scene scene;
    CounterRandom random(3);
    for (const auto& axes : {std::initializer_list<PoseAxis>{PoseAxis::AlongRay},
                             {PoseAxis::LaoRao, PoseAxis::Roll},
                             {PoseAxis::Right, PoseAxis::Up, PoseAxis::CraCau},
                             {PoseAxis::Roll, PoseAxis::AlongRay}}) {
        const PoseFreedom freedom = scene.freedom(axes);
        const Vector6d before = freedom.coordinates(scene.start);
        const CentroidPose after = freedom.retract(scene.start, scene.randomStep(random));
        const Vector6d change = freedom.coordinates(after) - before;
        const StepBasis free = freedom.freeSteps(scene.start);
        EXPECT_EQ(free.cols(), 6 - static_cast<Eigen::Index>(axes.size()));
        const Vector6d along = freedom.coordinates(retract(scene.start, 1e-6 * free.rowwise().sum())) - before;
        for (Eigen::Index k = 0; k < 6; ++k) {
            EXPECT_EQ(std::abs(change[k]) < 1e-10, freedom.isLocked(k)) << k;
            EXPECT_EQ(std::abs(along[k]) < 1e-9, freedom.isLocked(k)) << k;
        }
    }
}

TEST(PoseFreedom, AllFreeChangesNothing)
{
    const Scene scene;
    CounterRandom random(4);
    const Vector6d step = scene.randomStep(random);
    EXPECT_EQ(PoseFreedom().retract(scene.start, step).rotation, retract(scene.start, step).rotation);
    EXPECT_TRUE(PoseFreedom().isFull());
}

TEST(PoseFreedom, MotionsFromTheStartHaveTheSameCoordinates)
{
    const Scene scene;
    const PoseFreedom freedom = scene.freedom({PoseAxis::AlongRay});
    const RigidTransform initialPose{scene.start.rotation, {0.0, 0.0, 0.0}};
    CounterRandom random(5);
    const CentroidPose retract = core::retract(scene.start, scene.randomStep(random));
    const CentroidPose motion{retract.rotation * initialPose.rotation.transpose(), retract.centroidInCamera};
    const Vector6d gap = freedom.fromStart(initialPose.rotation).coordinates(motion) - freedom.coordinates(retract);
    EXPECT_LT(gap.norm(), 1e-11);
}

TEST(PoseFreedom, LocksMoreAtTheGivenPose)
{
    const Scene scene;
    CounterRandom random(6);
    const CentroidPose elsewhere = retract(scene.start, scene.randomStep(random));
    for (const PoseFreedom& freedom : {PoseFreedom(), scene.freedom({PoseAxis::AlongRay})}) {
        const PoseFreedom shifts =
            freedom.withLockedAxes({PoseAxis::Roll, PoseAxis::LaoRao, PoseAxis::CraCau}, elsewhere);
        const CentroidPose after = shifts.retract(elsewhere, scene.randomStep(random));
        EXPECT_LT((after.rotation - elsewhere.rotation).norm(), 1e-13);
        EXPECT_GT((after.centroidInCamera - elsewhere.centroidInCamera).norm(), 1.0);
    }
}

}   // namespace
