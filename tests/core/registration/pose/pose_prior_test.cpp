#include "core/registration/pose/pose_prior.h"

#include "core/support/random.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

Vector6d gaussianTwist(CounterRandom& random, double angle, double millimeters)
{
    Vector6d twist;
    for (int k = 0; k < 6; ++k) {
        twist(k) = (k < 3 ? angle : millimeters) * random.normal();
    }
    return twist;
}

TEST(PosePrior, JacobianMatchesFiniteDifferences)
{
    CounterRandom random(11);
    for (const double angle : {1e-4, 0.03, 0.4}) {
        const RigidTransform reference = expSe3(gaussianTwist(random, 0.5, 300.0));
        const RigidTransform pose = expSe3(gaussianTwist(random, angle, 30.0)) * reference;
        const PosePrior prior{reference, Vector6d::Ones(), 1.0};
        const Matrix6d analytic = priorJacobian(prior, pose);
        for (int k = 0; k < 6; ++k) {
            Vector6d step = Vector6d::Zero();
            step(k) = k < 3 ? 1e-6 : 1e-4;
            const Vector6d ahead = priorResidual(prior, expSe3(step) * pose);
            const Vector6d behind = priorResidual(prior, expSe3(-step) * pose);
            const Vector6d numeric = (ahead - behind) / (2.0 * step(k));
            EXPECT_LT((numeric - analytic.col(k)).norm(), 1e-6 * (1.0 + analytic.col(k).norm())) << angle << " " << k;
        }
    }
}

TEST(PosePrior, GradientMatchesTheCost)
{
    CounterRandom random(12);
    PosePrior prior{expSe3(gaussianTwist(random, 0.2, 100.0)), Vector6d::Ones(), 100.0};
    prior.weights.tail<3>().setConstant(1.0 / 800.0);
    const RigidTransform pose = expSe3(gaussianTwist(random, 0.1, 10.0)) * prior.reference;
    NormalEquations equations;
    addPrior(prior, pose, equations);
    for (int k = 0; k < 6; ++k) {
        Vector6d step = Vector6d::Zero();
        step(k) = k < 3 ? 1e-6 : 1e-4;
        const double slope =
            (priorCost(prior, expSe3(step) * pose) - priorCost(prior, expSe3(-step) * pose)) / (2.0 * step(k));
        EXPECT_NEAR(slope, 2.0 * equations.gradient(k), 1e-6 * (1.0 + std::abs(slope))) << k;
    }
}

TEST(PosePrior, IsZeroAtItsReference)
{
    CounterRandom random(13);
    const PosePrior prior{expSe3(gaussianTwist(random, 0.4, 200.0)), Vector6d::Ones(), 100.0};
    EXPECT_LT(priorCost(prior, prior.reference), 1e-20);
}

TEST(PosePrior, OneStepReturnsToTheReference)
{
    CounterRandom random(14);
    const PosePrior prior{expSe3(gaussianTwist(random, 0.4, 200.0)), Vector6d::Ones(), 7.0};
    RigidTransform pose = expSe3(gaussianTwist(random, 0.01, 1.0)) * prior.reference;
    for (int k = 0; k < 4; ++k) {
        NormalEquations equations;
        addPrior(prior, pose, equations);
        pose = expSe3(dampedStep(equations, 0.0)) * pose;
    }
    EXPECT_LT(priorResidual(prior, pose).norm(), 1e-9);
}

}   // namespace
