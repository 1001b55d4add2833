#include "core/simulation/contrast_path.h"

#include <gtest/gtest.h>
#include <cmath>

using namespace angiopose;

namespace {

using namespace core;

const ProjectionCamera contrastCamera{-2000.0, 2000.0, 100.0, 100.0, 201, 201};
constexpr double depthMm = 800.0;   // 2.5 px per mm

ContrastPath tubePath(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radiusMm)
{
    ContrastPath path;
    for (int i = 0; i <= 40; ++i) {
        path.push_back({from + (to - from) * i / 40.0, radiusMm, 1.0, 0.0});
    }
    return path;
}

ImageF filledThickness(const ContrastPath& path)
{
    return contrastThicknessMm({path}, {.injectionS = 1e9}, 100.0, contrastCamera, {});
}

double fullConcentration()
{
    return Bolus{.injectionS = 1e9}.concentration(0.0, 100.0);
}

TEST(ContrastPath, ATubeAcrossTheRayHasTheChordProfile)
{
    const ImageF image = filledThickness(tubePath({-30, 0, depthMm}, {30, 0, depthMm}, 3.0));
    for (int y = -6; y <= 6; ++y) {
        const double rhoMm = y / 2.5;
        const double chordMm = 2.0 * std::sqrt(9.0 - rhoMm * rhoMm);
        EXPECT_NEAR(image.at(100, 100 + y) / fullConcentration(), chordMm, 0.06 * 6.0) << y;
    }
    EXPECT_EQ(image.at(100, 110), 0.0F);
}

TEST(ContrastPath, ATubeTiltedTowardsTheRayLooksDenser)
{
    const double tilt = std::numbers::pi / 3.0;   // 60° out of the detector plane doubles the path length
    const Eigen::Vector3d half(20.0 * std::cos(tilt), 0.0, 20.0 * std::sin(tilt));
    const Eigen::Vector3d center(0.0, 0.0, depthMm);
    const ImageF image = filledThickness(tubePath(center - half, center + half, 1.5));
    EXPECT_NEAR(image.at(100, 100) / fullConcentration(), 2.0 * 3.0, 0.25);
}

TEST(ContrastPath, ContrastScalesWithOpacity)
{
    ContrastPath path = tubePath({-30, 0, depthMm}, {30, 0, depthMm}, 2.0);
    const double full = filledThickness(path).at(100, 100);
    for (ContrastPoint& point : path) {
        point.opacity = 0.4;
    }
    EXPECT_NEAR(filledThickness(path).at(100, 100), 0.4 * full, 1e-3);
}

TEST(Bolus, ArrivesLaterDownstreamAndWashesOut)
{
    const Bolus bolus;
    EXPECT_LT(bolus.concentration(150.0, 0.5), 0.01);
    EXPECT_GT(bolus.concentration(0.0, 0.5), 0.8);
    EXPECT_GT(bolus.concentration(150.0, 1.8), 0.8);
    EXPECT_LT(bolus.concentration(0.0, 4.5), 0.01);
    for (double time = 0.0; time < 5.0; time += 0.1) {
        EXPECT_GE(bolus.concentration(100.0, time), 0.0);
        EXPECT_LE(bolus.concentration(100.0, time), 1.0);
    }
}

}   // namespace
