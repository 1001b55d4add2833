#include "ui/views/image_sides.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

using namespace angiopose;

namespace {

/// Source behind the patient, viewed as if facing the patient: image right is the patient's left, up is the head.
core::RigidTransform frontal()
{
    Eigen::Matrix3d cameraFromPatient;
    cameraFromPatient << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    return {cameraFromPatient, {0, 0, 700}};
}

const core::ProjectionCamera camera{2000, 2000, 255.5, 255.5, 512, 512};

TEST(ImageSides, NameTheEdgesOfAFrontalView)
{
    const ui::ImageSides sides = ui::imageSides(camera, frontal());
    EXPECT_EQ(sides.left, "R");
    EXPECT_EQ(sides.right, "L");
    EXPECT_EQ(sides.top, "H");
    EXPECT_EQ(sides.bottom, "F");
}

TEST(ImageSides, SwapInAMirroredImage)
{
    core::ProjectionCamera mirrored = camera;
    mirrored.fx = -mirrored.fx;
    EXPECT_EQ(ui::imageSides(mirrored, frontal()).left, "L");
    EXPECT_EQ(ui::imageSides(mirrored, frontal()).top, "H");
}

TEST(ImageSides, NameTwoSidesWhenTheViewIsAskew)
{
    core::RigidTransform oblique = frontal();
    oblique.rotation =
        oblique.rotation * Eigen::AngleAxisd(std::numbers::pi / 5.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const ui::ImageSides sides = ui::imageSides(camera, oblique);
    EXPECT_EQ(sides.right.size(), 2U);
    EXPECT_EQ(sides.right.front(), 'L');
    EXPECT_EQ(sides.left.front(), 'R');
    EXPECT_EQ(sides.top, "H");
}

}   // namespace
