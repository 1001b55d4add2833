#include "core/registration/judging/observed_diameter.h"

#include "core/registration/matching/grid_index.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>

#include <cmath>

namespace angiopose::core {
namespace {

/// A tree on its own projection, with expected and observed widths set by the test.
struct ObservedDiameterTest : ::testing::Test {
    ObservedDiameter seen() const
    {
        const TargetLines lines(problem.target, problem.camera);
        return observedDiameter(problem, lines, clean.truth,
                                projectTree(problem, clean.truth, GridIndex(problem.target.points)));
    }
    /// Sets the radii `expectedMm` and `seenMm` as functions of the height in the image, 0 at the top and 1 at the
    /// bottom.
    void setRadii(double (*expectedMm)(double), double (*seenMm)(double))
    {
        const double mmPerPx = millimetersPerPixel(problem.camera, (clean.truth * problem.tree.centroid).z());
        const auto height = static_cast<double>(problem.camera.height);
        for (std::size_t i = 0; i < problem.tree.size(); ++i) {
            const auto pixel = project(problem.camera, clean.truth * problem.tree.points[i]);
            problem.tree.radiusMm[i] = pixel ? expectedMm(pixel->y() / height) : 0.0;
        }
        for (std::size_t i = 0; i < problem.target.size(); ++i) {
            problem.target.radiusPx[i] = seenMm(problem.target.points[i].y() / height) / mmPerPx;
        }
    }

    test::CleanCase clean{4};
    RegistrationProblem problem = makeProblem(clean.from(clean.truth), {}).value();
};

double tapering(double at)
{
    return std::exp(-3.0 * (at - 0.5));
}

TEST_F(ObservedDiameterTest, VesselsThatTaperAsTheTreeDoesAreLumen)
{
    setRadii(tapering, [](double at) { return 0.9 * tapering(at); });
    const ObservedDiameter diameter = seen();
    EXPECT_GT(diameter.pairs, problem.tree.size() / 2);
    EXPECT_NEAR(diameter.ratio, 0.9, 0.05);
    EXPECT_GT(diameter.correlation, 0.9);
    EXPECT_TRUE(isLumen(diameter));
}

TEST_F(ObservedDiameterTest, VesselsOfOneWidthTellNothing)
{
    setRadii([](double) { return 2.5; }, [](double) { return 2.3; });   // a sheath could look like this
    EXPECT_NEAR(seen().ratio, 0.92, 0.05);
    EXPECT_FALSE(isLumen(seen()));
}

TEST_F(ObservedDiameterTest, ACatheterIsNoLumen)
{
    setRadii(tapering, [](double) { return 0.9; });   // about the median width of the vessels
    EXPECT_NEAR(seen().ratio, 1.0, 0.4);
    EXPECT_FALSE(isLumen(seen()));
}

TEST_F(ObservedDiameterTest, AWireIsNoLumen)
{
    setRadii([](double at) { return 3.0 * tapering(at); }, [](double at) { return 0.2 * tapering(at); });
    EXPECT_LT(seen().ratio, 0.2);
    EXPECT_FALSE(isLumen(seen()));
}

TEST_F(ObservedDiameterTest, NothingIsKnownWithoutWidths)
{
    setRadii(tapering, [](double) { return 0.0; });
    EXPECT_EQ(seen().pairs, 0U);
    EXPECT_FALSE(isLumen(seen()));
    setRadii([](double) { return 0.0; }, tapering);
    EXPECT_EQ(seen().pairs, 0U);
}

}   // namespace
}   // namespace angiopose::core
