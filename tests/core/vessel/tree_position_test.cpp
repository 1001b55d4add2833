#include "core/vessel/tree_position.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

VesselTree crossing()
{
    VesselTree tree;
    tree.branches.push_back({1, "", {{-20.0, 0.0, 0.0}, {20.0, 0.0, 0.0}}, {}, -1});
    tree.branches.push_back({2, "", {{0.0, -20.0, 50.0}, {0.0, 20.0, 50.0}}, {}, -1});
    return tree;
}

TEST(PlaceOnTree, IsBetweenThePointsOfABranch)
{
    const auto place = nearestPointOnTree(crossing(), {7.0, 3.0, 1.0});
    ASSERT_TRUE(place);
    EXPECT_TRUE(place->isApprox(Eigen::Vector3d(7.0, 0.0, 0.0))) << place->transpose();
    const auto end = nearestPointOnTree(crossing(), {90.0, 5.0, 0.0});
    ASSERT_TRUE(end);
    EXPECT_TRUE(end->isApprox(Eigen::Vector3d(20.0, 0.0, 0.0)));
    EXPECT_FALSE(nearestPointOnTree({}, {0.0, 0.0, 0.0}));
}

TEST(PlaceOnTree, IsFoundUnderThePixelThatShowsIt)
{
    const PosedCamera posedCamera{{-2000.0, 2000.0, 256.0, 256.0, 512, 512},
                                  {Eigen::Matrix3d::Identity(), {0.0, 0.0, 700.0}}};
    const Eigen::Vector3d shown(0.0, 12.0, 50.0);
    const auto pixel = project(posedCamera.camera, posedCamera.cameraFromPatient * shown);
    ASSERT_TRUE(pixel);
    const auto place = pointUnderPixel(crossing(), posedCamera, *pixel + Eigen::Vector2d(3.0, 0.0), 8.0);
    ASSERT_TRUE(place);
    EXPECT_LT((*place - shown).norm(), 1e-9);
    EXPECT_FALSE(pointUnderPixel(crossing(), posedCamera, {500.0, 500.0}, 8.0));
}

TEST(PlaceOnTree, BehindTheSourceIsNowhere)
{
    const PosedCamera posedCamera{{-2000.0, 2000.0, 256.0, 256.0, 512, 512},
                                  {Eigen::Matrix3d::Identity(), {0.0, 0.0, -700.0}}};
    EXPECT_FALSE(pointUnderPixel(crossing(), posedCamera, {256.0, 256.0}, 1e6));
}

}   // namespace
}   // namespace angiopose::core
