#include "core/registration/pose/centroid_pose.h"
#include "core/registration/register_views.h"
#include "core/simulation/degrade_target.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr double inside95 = 12.592;   // 95 % quantile of χ² with six degrees of freedom
const CameraUncertainty headerSpread{0.029, 8.0};

RegistrationInput noisyInput(const test::CleanCase& clean, const RigidTransform& truth, std::uint64_t seed)
{
    RegistrationInput input = clean.from(truth);
    input.target = addTracingErrors(projectTree(clean.tree, clean.camera, truth), clean.camera, CounterRandom(seed));
    return input;
}

void stretchFocalLength(RegistrationInput& input, double factor)
{
    input.camera.fx *= factor;
    input.camera.fy *= factor;
}

/// Squared error normalized by the covariance (Mahalanobis distance).
double normalizedError(const test::CleanCase& clean, const RigidTransform& truth, const RigidTransform& pose,
                       const Matrix6d& covariance)
{
    const Eigen::Vector3d centroid = centroidInPatient(clean.tree);
    const Vector6d error = stepBetween(aboutCentroid(pose, centroid), aboutCentroid(truth, centroid));
    return error.dot(covariance.ldlt().solve(error));
}

bool speaksOfCamera(const Message& message)
{
    return message.text().find("fit clearly better with") != std::string::npos;
}

TEST(WrongGeometry, TheCovarianceHoldsTheTruthOfAWrongDistance)
{
    for (const double factor : {0.95, 1.05}) {
        const test::CleanCase clean(3);
        RegistrationInput input = noisyInput(clean, clean.truth, 5);
        stretchFocalLength(input, factor);
        const RegistrationResult trusting = registerVessels(input).value();
        input.cameraUncertainty = headerSpread;
        const RegistrationResult result = registerVessels(input).value();
        const auto nees = [&](const RegistrationResult& each) {
            return normalizedError(clean, clean.truth, each.cameraFromPatient, each.uncertainty.covariance);
        };
        EXPECT_GT(nees(trusting), 100.0) << factor;
        EXPECT_LT(nees(result), inside95) << factor;
        EXPECT_TRUE(result.trustworthy) << factor;
    }
}

TEST(WrongGeometry, TheDepthIsAsUncertainAsTheFocalLength)
{
    const test::CleanCase clean(3);
    RegistrationInput input = noisyInput(clean, clean.truth, 5);
    input.cameraUncertainty = {0.005, 0.0};   // smaller than what a single view can determine
    const RegistrationResult result = registerVessels(input).value();
    const double depthMm = (result.cameraFromPatient * centroidInPatient(clean.tree)).z();
    EXPECT_NEAR(result.uncertainty.depthMm, 0.005 * depthMm, 0.1 * 0.005 * depthMm);
    EXPECT_LT(result.uncertainty.imageCovariance(5, 5), 25.0);
    EXPECT_TRUE(std::ranges::none_of(result.warnings, speaksOfCamera));
}

TEST(WrongGeometry, OptionsOverruleWhereTheValuesComeFrom)
{
    const test::CleanCase clean(3);
    RegistrationInput input = noisyInput(clean, clean.truth, 5);
    const RegistrationResult exact = registerVessels(input).value();
    input.cameraUncertainty = headerSpread;
    RegistrationOptions options;
    options.geometry.spread = GeometrySpread::None;
    const RegistrationResult none = registerVessels(input, options).value();
    EXPECT_EQ(none.uncertainty.covariance, exact.uncertainty.covariance);
    EXPECT_FALSE(none.camera.has_value());
    options.geometry.spread = GeometrySpread::Given;
    options.geometry.focalPercent = 10.0;
    options.geometry.principalPx = 0.0;
    const RegistrationResult given = registerVessels(input, options).value();
    EXPECT_GT(given.uncertainty.depthMm, 3.0 * exact.uncertainty.depthMm);
    ASSERT_TRUE(given.camera.has_value());
}

/// Two views 60° apart from one gantry whose distance is wrong by `factor`.
MultiViewResult twoViews(double factor)
{
    const test::CleanCase clean(3);
    const Eigen::Vector3d isocenter(0.0, 0.0, 790.0);
    const Eigen::Matrix3d turn = expSo3({0.0, std::numbers::pi / 3.0, 0.0});
    const std::array<RigidTransform, 2> truth{clean.truth,
                                              RigidTransform{turn, isocenter - turn * isocenter} * clean.truth};
    std::array<RegistrationInput, 2> inputs;
    for (std::size_t k = 0; k < 2; ++k) {
        inputs[k] = noisyInput(clean, truth[k], 11 + k);
        inputs[k].cameraUncertainty = headerSpread;
        stretchFocalLength(inputs[k], factor);
    }
    return registerViews(inputs).value();
}

TEST(WrongGeometry, TwoViewsNameAWrongDistance)
{
    const MultiViewResult result = twoViews(0.95);
    ASSERT_EQ(result.cameras.size(), 2U);
    EXPECT_NEAR(result.cameras[0].error[0], 0.051, 0.015);
    EXPECT_NEAR(result.cameras[1].error[0], 0.051, 0.015);
    EXPECT_GE(std::ranges::count_if(result.warnings, speaksOfCamera), 1);
}

TEST(WrongGeometry, TwoViewsAreSilentOfARightOne)
{
    const MultiViewResult result = twoViews(1.0);
    EXPECT_TRUE(result.trustworthy);
    EXPECT_TRUE(std::ranges::none_of(result.warnings, speaksOfCamera));
    EXPECT_LT(std::abs(result.cameras[0].error[0]), 0.01);
}

}   // namespace
}   // namespace angiopose::core
