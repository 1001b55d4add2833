// The toy square of ALGORITHMS §4.1: point-to-point methods lock in one tooth off on its evenly spaced points.
#include "core/evaluation/trial/projection_error.h"
#include "core/registration/registration.h"
#include "core/simulation/simulated_case.h"

#include "core/geometry/angle_units.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>

namespace angiopose::core {
namespace {

struct ToySquare {
    /// Square with `segments` segments per edge; every edge is a branch.
    explicit ToySquare(int segments)
    {
        const std::array<Eigen::Vector3d, 4> corners{Eigen::Vector3d(5.0, 0.0, 10.0), Eigen::Vector3d(10.0, 0.0, 10.0),
                                                     Eigen::Vector3d(10.0, 0.0, 15.0), Eigen::Vector3d(5.0, 0.0, 15.0)};
        for (std::size_t edge = 0; edge < 4; ++edge) {
            VesselBranch branch{static_cast<int>(edge) + 1, {}, {}, {}};
            for (int i = 0; i <= segments; ++i) {
                const double share = static_cast<double>(i) / segments;
                branch.pointsInPatient.push_back((1.0 - share) * corners[edge] + share * corners[(edge + 1) % 4]);
            }
            input.tree.branches.push_back(branch);
        }
        input.camera = {520.0, 520.0, 512.0, 512.0, 1024, 1024};
        options.pointSpacingMm = std::max(0.2, 5.0 / segments);
    }

    /// Error after registering the projection from `pose`, starting off by one unit in a random direction and `turn`
    /// (rad) about the source.
    double errorPx(const RigidTransform& pose, double turn, CounterRandom& random)
    {
        const auto direction = [&random] {
            const double x = random.normal();
            const double y = random.normal();
            const double z = random.normal();
            return Eigen::Vector3d(x, y, z).normalized();
        };
        input.target = projectTree(input.tree, input.camera, pose);
        const RigidTransform off{expSo3(turn * direction()), direction()};
        input.initialCameraFromPatient = off * pose;
        const auto result = registerVessels(input, options);
        return result ? projectionError(input.tree, input.camera, {result.value().cameraFromPatient, pose}).meanPx
                      : 1e9;
    }

    RegistrationInput input;
    RegistrationOptions options;
};

/// Variant T-B: tilted by 30° so that the projection is unambiguously a square.
RigidTransform tilted()
{
    const Eigen::Matrix3d turn = expSo3({30.0 * radiansPerDegree, 0.0, 0.0});
    return {turn, Eigen::Vector3d(0.0, 0.0, 12.5) - turn * Eigen::Vector3d(7.5, 0.0, 12.5)};
}

class ToySquareSizes : public ::testing::TestWithParam<int> {};

TEST_P(ToySquareSizes, NeverLocksOneToothOff)
{
    ToySquare square(GetParam());
    CounterRandom random(5);
    for (int draw = 0; draw < 10; ++draw) {
        EXPECT_LT(square.errorPx(tilted(), 0.0, random), 1.0) << "shift only, draw " << draw;
        EXPECT_LT(square.errorPx(tilted(), 1.0 * radiansPerDegree, random), 1.0) << "with a turn, draw " << draw;
    }
}

INSTANTIATE_TEST_SUITE_P(Segments, ToySquareSizes, ::testing::Values(11, 21, 31, 41),
                         [](const auto& segments) { return std::to_string(4 * segments.param) + "_points"; });

TEST(ToySquare, SeenEdgeOnIsFlaggedAsUndetermined)
{
    ToySquare square(21);
    CounterRandom random(6);
    square.errorPx({}, 0.0, random);
    const auto result = registerVessels(square.input, square.options);
    ASSERT_TRUE(result);
    EXPECT_FALSE(result.value().trustworthy);
    const auto& observed = result.value().uncertainty.observed;
    EXPECT_LT(std::count(observed.begin(), observed.end(), true), 6);
}

}   // namespace
}   // namespace angiopose::core
