#include "core/simulation/deform_tree.h"

#include "core/simulation/simulated_case.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

TEST(DeformTree, MovesPointsByTheAskedDeviationAndNeighborsAlike)
{
    const VesselTree tree = simulateTree(1);
    double squares = 0.0;
    double neighborSquares = 0.0;
    double count = 0.0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        CounterRandom random(seed);
        const VesselTree warped = deformed(tree, 2.0, random);
        const auto& from = tree.branches[0].pointsInPatient;
        const auto& to = warped.branches[0].pointsInPatient;
        for (std::size_t i = 0; i + 1 < from.size(); ++i) {
            const Eigen::Vector3d shift = to[i] - from[i];
            squares += shift.squaredNorm() / 3.0;
            neighborSquares += (to[i + 1] - from[i + 1] - shift).squaredNorm() / 3.0;
            count += 1.0;
        }
    }
    EXPECT_NEAR(std::sqrt(squares / count), 2.0, 0.3);
    // A Gaussian process with a correlation length of 40 mm changes by σ/40 per mm.
    EXPECT_NEAR(std::sqrt(neighborSquares / count), 2.0 / 40.0, 0.02);
}

}   // namespace
