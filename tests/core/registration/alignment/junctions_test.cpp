#include "core/registration/alignment/junctions.h"

#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <algorithm>

namespace angiopose::core {
namespace {

/// Appends points from `from` to `to`, 1 px apart.
void addLine(std::vector<Eigen::Vector2d>& points, std::vector<int>& curve, const Eigen::Vector2d& from,
             const Eigen::Vector2d& to)
{
    const int index = curve.empty() ? 0 : curve.back() + 1;
    const int steps = static_cast<int>((to - from).norm());
    for (int i = 0; i <= steps; ++i) {
        points.emplace_back(from + (to - from) * i / steps);
        curve.push_back(index);
    }
}

TEST(Junctions, AreWhereAnEndTouchesAnotherCurve)
{
    std::vector<Eigen::Vector2d> points;
    std::vector<int> curve;
    addLine(points, curve, {0.0, 0.0}, {100.0, 0.0});
    addLine(points, curve, {50.0, 2.0}, {50.0, 80.0});
    addLine(points, curve, {0.0, 60.0}, {100.0, 60.0});   // a crossing curve that does not end there
    const auto junctions = findJunctions<2>(points, curve, {5.0, 20.0});
    ASSERT_EQ(junctions.size(), 1u);
    EXPECT_LT((junctions.front().point - Eigen::Vector2d(50.0, 0.0)).norm(), 2.5);
    ASSERT_EQ(junctions.front().directions.size(), 3u);
    for (const Eigen::Vector2d& way : {Eigen::Vector2d(1.0, 0.0), {-1.0, 0.0}, {0.0, 1.0}}) {
        EXPECT_TRUE(std::any_of(junctions.front().directions.begin(), junctions.front().directions.end(),
                                [&](const Eigen::Vector2d& found) { return found.dot(way) > 0.99; }));
    }
}

TEST(Junctions, OfThreeEndsAreOne)
{
    std::vector<Eigen::Vector2d> points;
    std::vector<int> curve;
    addLine(points, curve, {1.0, 0.0}, {60.0, 0.0});
    addLine(points, curve, {-50.0, 30.0}, {-1.0, 1.0});
    addLine(points, curve, {0.0, -1.0}, {-40.0, -40.0});
    const auto junctions = findJunctions<2>(points, curve, {5.0, 20.0});
    ASSERT_EQ(junctions.size(), 1u);
    EXPECT_EQ(junctions.front().directions.size(), 3u);
}

TEST(Junctions, OfATreeAreThoseOfItsProjection)
{
    const test::CleanCase clean(2);
    const RegistrationProblem problem = makeProblem(clean.from(clean.truth), {}).value();
    const auto nodes = findJunctions<3>(problem.tree.points, problem.tree.branchIndex, {2.5, 12.0});
    const auto junctions = findJunctions<2>(problem.target.points, problem.target.curveIndex, {5.0, 20.0});
    EXPECT_GT(nodes.size(), 10u);
    const auto seen = std::count_if(nodes.begin(), nodes.end(), [&](const Junction<3>& node) {
        const Eigen::Vector2d pixel = *project(clean.camera, clean.truth * node.point);
        return std::any_of(junctions.begin(), junctions.end(),
                           [&](const Junction<2>& junction) { return (junction.point - pixel).norm() < 8.0; });
    });
    EXPECT_GE(seen, static_cast<std::ptrdiff_t>(nodes.size() - 3));   // branches seen end-on do not show a third arm
}

}   // namespace
}   // namespace angiopose::core
