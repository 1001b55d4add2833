#include "core/registration/alignment/territory_search.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

constexpr double depthMm = 750.0;
constexpr double betweenMm = 30.0;
constexpr double wideMm = 2.5;
constexpr double fineMm = 0.6;

/// Two parallel vessels of the same shape; the image shows only one of them.
struct TerritorySearchTest : ::testing::Test {
    TerritorySearchTest()
    {
        for (const double side : {-1.0, 1.0}) {
            for (int i = 0; i <= 80; ++i) {
                const double along = 0.5 * i - 20.0;
                const double deformation = 0.01 * along * along;
                points.push_back({{0.5 * side * betweenMm + deformation, along, 0.0},
                                  Eigen::Vector3d(0.02 * along, 1.0, 0.0).normalized(),
                                  side < 0.0 ? 0 : 1});
            }
        }
        for (int i = 0; i <= 80; ++i) {   // midway between the two
            const AlignmentPoint& point = points[static_cast<std::size_t>(i)];
            const Eigen::Vector3d middle = point.fromCentroid + Eigen::Vector3d(0.5 * betweenMm, 0.0, depthMm);
            target.points.push_back(*project(camera, middle));
            target.tangents.push_back(point.tangent.head<2>().normalized());
            target.curveIndex.push_back(0);
        }
        target.radiusPx.assign(target.points.size(), 0.0);
        start.centroidInCamera.z() = depthMm;
    }

    std::vector<CoarseCandidate> found(const std::vector<double>& radiusPx, const std::vector<double>& radiusMm) const
    {
        const TargetLines lines(target, camera);
        SearchRange range;
        range.tiltDeg = range.rollDeg = 0.0;
        TerritorySearch search(camera, lines, radiusPx);
        return search.find(points, radiusMm, start, range, [](double) { return ObserverDecision::Continue; });
    }
    /// Best shift to the right for the given radii of the left and the right vessel and the observed radius, mm.
    double shiftMm(double leftMm, double rightMm, double seenMm) const
    {
        std::vector<double> radiusMm(points.size(), rightMm);
        std::fill_n(radiusMm.begin(), points.size() / 2, leftMm);
        const std::vector<double> radiusPx(target.size(), seenMm / millimetersPerPixel(camera, depthMm));
        return found(radiusPx, radiusMm).front().pose.centroidInCamera.x();
    }

    ProjectionCamera camera{2000.0, 2000.0, 255.5, 255.5, 512, 512};
    std::vector<AlignmentPoint> points;
    TargetSamples target;
    CentroidPose start;
};

TEST_F(TerritorySearchTest, LooksForAVesselAmongThoseOfItsWidth)
{
    EXPECT_NEAR(shiftMm(wideMm, fineMm, wideMm), 0.5 * betweenMm, 4.0);
    EXPECT_NEAR(shiftMm(fineMm, wideMm, wideMm), -0.5 * betweenMm, 4.0);
    EXPECT_NEAR(shiftMm(wideMm, fineMm, fineMm), -0.5 * betweenMm, 4.0);
}

TEST_F(TerritorySearchTest, ForgivesThatEverythingIsTracedTooWideOrTooNarrow)
{
    EXPECT_NEAR(shiftMm(wideMm, fineMm, 1.4 * wideMm), 0.5 * betweenMm, 4.0);
    EXPECT_NEAR(shiftMm(wideMm, fineMm, 0.7 * wideMm), 0.5 * betweenMm, 4.0);
}

TEST_F(TerritorySearchTest, IsAsEverWhereTreeOrImageTellNoWidths)
{
    const std::vector<double> mixed = [&] {
        std::vector<double> radii(points.size(), fineMm);
        std::fill_n(radii.begin(), points.size() / 2, wideMm);
        return radii;
    }();
    const auto plain = found({}, {});
    for (const auto& other :
         {found(target.radiusPx, mixed), found(std::vector<double>(target.size(), 6.0), {}),
          found(std::vector<double>(target.size(), 6.0), std::vector<double>(points.size(), 0.0))}) {
        ASSERT_EQ(other.size(), plain.size());
        for (std::size_t k = 0; k < plain.size(); ++k) {
            EXPECT_EQ(other[k].score, plain[k].score);
            EXPECT_EQ(other[k].pose.centroidInCamera, plain[k].pose.centroidInCamera);
        }
    }
}

}   // namespace
}   // namespace angiopose::core
