#include "core/registration/judging/within_2mm.h"

#include "core/registration/registration.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <cmath>

namespace angiopose::core {
namespace {

RegistrationResult foundFrom(const RegistrationInput& input, const RegistrationOptions& options = {})
{
    const auto result = registerVessels(input, options);
    EXPECT_TRUE(result);
    return result.value();
}

TEST(Within2Mm, IsLikelyWhereTheTreeLiesOnItsVessels)
{
    for (const std::uint64_t seed : {1, 2, 3}) {
        const test::CleanCase clean(seed);
        const RegistrationResult result = foundFrom(clean.fromNearby(seed));
        ASSERT_TRUE(result.probabilityWithin2Mm);
        EXPECT_GT(*result.probabilityWithin2Mm, 0.95) << "tree " << seed;
    }
}

TEST(Within2Mm, IsUnlikelyOfAnotherTree)
{
    for (const std::uint64_t seed : {1, 2, 3}) {
        const test::CleanCase clean(seed);
        RegistrationInput input = clean.fromNearby(seed);
        input.target = test::CleanCase(seed + 10).target;
        const RegistrationResult result = foundFrom(input);
        ASSERT_TRUE(result.probabilityWithin2Mm);
        EXPECT_LT(*result.probabilityWithin2Mm, 0.5) << "tree " << seed;
    }
}

TEST(Within2Mm, IsNotKnownOfOtherMethodsStopsAndJudgedPoses)
{
    const test::CleanCase clean(1);
    const RegistrationInput input = clean.fromNearby(1);
    RegistrationOptions options;
    options.method = "dt-icp";
    EXPECT_FALSE(foundFrom(input, options).probabilityWithin2Mm);
    const auto stopped = registerVessels(input, {}, [](const IterationReport&) { return ObserverDecision::Stop; });
    ASSERT_TRUE(stopped);
    EXPECT_FALSE(stopped.value().probabilityWithin2Mm);
    const auto judged = evaluatePose(input, clean.truth);
    ASSERT_TRUE(judged);
    EXPECT_FALSE(judged.value().probabilityWithin2Mm);
}

TEST(Within2Mm, TakesSignsThatAreNoNumbers)
{
    RegistrationResult result;
    result.metrics.medianMm = std::nan("");
    result.metrics.p95Mm = std::numeric_limits<double>::infinity();
    result.metrics.coverage = std::nan("");
    for (const double value : featureVector(result)) {
        EXPECT_TRUE(std::isfinite(value));
    }
    EXPECT_LT(overlayProbability(result), 0.5);
}

}   // namespace
}   // namespace angiopose::core
