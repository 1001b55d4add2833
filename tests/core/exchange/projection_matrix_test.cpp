#include "core/exchange/projection_matrix.h"

#include "core/messages/messages.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <limits>

using namespace angiopose;

namespace {

using namespace core;

const RigidTransform somePose{expSo3({0.4, -1.1, 2.0}), {12.5, -7.25, 741.0}};
const ProjectionCamera standard{-2281.3, 2279.9, 250.5, 261.25, 512, 512};

void expectCamera(const ProjectionCamera& found, const ProjectionCamera& wanted)
{
    EXPECT_NEAR(found.fx, wanted.fx, 1e-8);
    EXPECT_NEAR(found.fy, wanted.fy, 1e-8);
    EXPECT_NEAR(found.cx, wanted.cx, 1e-8);
    EXPECT_NEAR(found.cy, wanted.cy, 1e-8);
}

TEST(ProjectionMatrix, ProjectsAsTheCameraDoes)
{
    const Eigen::Vector3d point(31.0, -12.0, 45.0);
    const Eigen::Vector3d image = projectionMatrix({standard, somePose}) * point.homogeneous();
    const Eigen::Vector2d pixel = *project(standard, somePose * point);
    EXPECT_LT((image.hnormalized() - pixel).norm(), 1e-10);
    EXPECT_NEAR(image.z(), (somePose * point).z(), 1e-10);
}

TEST(ProjectionMatrix, IsTakenApartWithAndWithoutMirror)
{
    for (const double sign : {-1.0, 1.0}) {
        ProjectionCamera camera = standard;
        camera.fx *= sign;
        for (const double factor : {1.0, 1e-4, 350.0}) {
            const auto found = posedCameraFromMatrix(factor * projectionMatrix({camera, somePose}));
            ASSERT_TRUE(found);
            expectCamera(found.value().camera, camera);
            EXPECT_LT((found.value().cameraFromPatient.matrix() - somePose.matrix()).cwiseAbs().maxCoeff(), 1e-9);
            EXPECT_NEAR(found.value().cameraFromPatient.rotation.determinant(), 1.0, 1e-12);
        }
    }
}

TEST(ProjectionMatrix, RefusesSkewAndWhatIsNoCamera)
{
    Eigen::Matrix3d K = intrinsicMatrix(standard);
    K(0, 1) = 3.0;
    const ProjectionMatrix skewed = K * somePose.matrix().topRows<3>();
    EXPECT_TRUE(posedCameraFromMatrix(skewed).error().message.is(messages::projectionSkewed));
    EXPECT_TRUE(posedCameraFromIntrinsics(K, somePose.rotation, somePose.translation)
                    .error()
                    .message.is(messages::projectionSkewed));

    ProjectionMatrix flat = projectionMatrix({standard, somePose});
    flat.row(1) = 2.0 * flat.row(0);
    EXPECT_TRUE(posedCameraFromMatrix(flat).error().message.is(messages::projectionDegenerate));
    flat(0, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(posedCameraFromMatrix(flat).error().message.is(messages::projectionNotFinite));
}

TEST(ProjectionMatrix, IntrinsicsStayToTheLastBit)
{
    const auto found = posedCameraFromIntrinsics(intrinsicMatrix(standard), somePose.rotation, somePose.translation);
    ASSERT_TRUE(found);
    EXPECT_EQ(found.value().cameraFromPatient.rotation, somePose.rotation);
    EXPECT_EQ(found.value().cameraFromPatient.translation, somePose.translation);
    EXPECT_EQ(found.value().camera.fx, standard.fx);
    EXPECT_EQ(found.value().camera.cy, standard.cy);
}

/// A reflection in R or a negative fy are other representations of the same projection.
TEST(ProjectionMatrix, MirrorsAndHalfTurnsOfIntrinsicsProjectTheSame)
{
    const Eigen::Vector3d point(31.0, -12.0, 45.0);
    const Eigen::Vector2d pixel = *project(standard, somePose * point);
    for (const Eigen::Vector3d& signs :
         {Eigen::Vector3d(-1, 1, 1), Eigen::Vector3d(1, -1, 1), Eigen::Vector3d(-1, -1, 1)}) {
        const Eigen::Matrix3d flip = signs.asDiagonal();
        const auto found = posedCameraFromIntrinsics(intrinsicMatrix(standard) * flip, flip * somePose.rotation,
                                                     flip * somePose.translation);
        ASSERT_TRUE(found);
        EXPECT_GT(found.value().camera.fy, 0.0);
        EXPECT_NEAR(found.value().cameraFromPatient.rotation.determinant(), 1.0, 1e-12);
        EXPECT_LT((*project(found.value().camera, found.value().cameraFromPatient * point) - pixel).norm(), 1e-10);
    }
}

TEST(ProjectionMatrix, RoundedRotationsAreMadeRotationsAndScaledOnesRefused)
{
    const Eigen::Matrix3d rounded = (somePose.rotation * 1e4).array().round() / 1e4;
    const auto found = posedCameraFromIntrinsics(intrinsicMatrix(standard), rounded, somePose.translation);
    ASSERT_TRUE(found);
    EXPECT_TRUE(isRigid(found.value().cameraFromPatient, 1e-12));
    EXPECT_TRUE(posedCameraFromIntrinsics(intrinsicMatrix(standard), 1.01 * somePose.rotation, somePose.translation)
                    .error()
                    .message.is(messages::projectionNoRotation));
    EXPECT_TRUE(
        posedCameraFromIntrinsics(intrinsicMatrix(standard).transpose(), somePose.rotation, somePose.translation)
            .error()
            .message.is(messages::projectionIntrinsics));
}

}   // namespace
