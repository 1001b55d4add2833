#include "core/registration/judging/pose_uncertainty.h"

#include "core/simulation/degrade_target.h"
#include "core/simulation/phantom.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

/// 1-σ of the depth at the true pose on some degraded images, mean; the tree has so many points.
double depthStdWith(int points)
{
    constexpr std::uint64_t images = 6;
    const Phantom shown = makePhantom(1000, 2000);
    RegistrationOptions options;
    options.resample = 0;
    RegistrationInput input;
    input.tree = makePhantom(1000, points).tree;
    input.camera = shown.camera;
    input.initialCameraFromPatient = shown.trueCameraFromPatient;
    double sum = 0.0;
    for (std::uint64_t image = 0; image < images; ++image) {
        input.target = degraded(shown.exactTarget, shown.camera, CounterRandom(image));
        const RegistrationProblem problem = makeProblem(input, options).value();
        const StartPrior prior = startPrior(aboutCentroid(problem.start, problem.tree.centroid), options);
        sum += poseUncertainty(problem, TargetLines(problem.target, problem.camera), problem.start, prior).depthMm /
               images;
    }
    return sum;
}

// Points closer than the image is sampled tell nothing new. Counted as if they did, 50 times as many make the depth
// look three times as certain, while the errors stay as they are.
TEST(PoseUncertainty, DoesNotShrinkWithPointsThatTellNothingNew)
{
    const double usual = depthStdWith(2000);
    EXPECT_NEAR(depthStdWith(100000), usual, 0.15 * usual);
}

}   // namespace
}   // namespace angiopose::core