#include "app/registration/target_provider.h"

#include "core/simulation/simulated_case.h"
#include "tests/app/wait_for.h"

#include <gtest/gtest.h>
#include <QTest>

namespace angiopose::app {
namespace {

core::Case caseWith(std::shared_ptr<const core::Angiogram> run)
{
    core::Case result;
    result.shown().frame = run->suggestedFrame;
    result.shown().angiogram = std::move(run);
    return result;
}

std::shared_ptr<const core::Angiogram> simulatedRun()
{
    return std::make_shared<const core::Angiogram>(core::simulateCase(7).angiogram);
}

bool isReady(const TargetProvider& provider)
{
    return test::waitFor([&provider] { return provider.current() && !provider.isTracing(); });
}

TEST(TargetProvider, RemembersTracesButKeepsNoRunAlive)
{
    TargetProvider provider;
    auto first = caseWith(simulatedRun());
    const auto second = caseWith(simulatedRun());
    const std::weak_ptr<const core::Angiogram> firstRun = first.shown().angiogram;
    provider.setCase(first);
    ASSERT_TRUE(isReady(provider));
    const SharedTrace traced = provider.trace();
    provider.setCase(second);
    ASSERT_TRUE(isReady(provider));

    provider.setCase(first);
    EXPECT_EQ(provider.trace(), traced);   // immediately
    provider.setCase(second);
    first.shown().angiogram.reset();   // the case is closed
    EXPECT_TRUE(firstRun.expired());
}

/// The case with its own given curves.
core::Case given(core::Case session)
{
    session.shown().target.centerline = std::make_shared<const core::Centerline2d>(
        core::Centerline2d{{core::Curve2d{1, {{5.0, 5.0}, {90.0, 70.0}}, {}}}});
    return session;
}

TEST(TargetProvider, KeepsCurvesGivenWhileAFrameIsTraced)
{
    TargetProvider provider;
    const auto traced = caseWith(simulatedRun());
    const auto wanted = given(traced);
    bool isKnown = false;
    QObject::connect(&provider, &TargetProvider::changed, [&] { isKnown = !provider.isTracing(); });
    provider.setCase(traced);
    EXPECT_TRUE(provider.isTracing());
    provider.setCase(wanted);
    ASSERT_TRUE(isReady(provider));
    EXPECT_EQ(provider.current(), wanted.shown().target.centerline);
    EXPECT_TRUE(isKnown) << "that nothing is traced any more";
}

TEST(TargetProvider, TellsWhenATraceEndsThatNobodyWantsAnyMore)
{
    TargetProvider provider;
    auto session = caseWith(simulatedRun());
    provider.setCase(session);
    ASSERT_TRUE(isReady(provider));
    bool isKnown = false;
    QObject::connect(&provider, &TargetProvider::changed, [&] { isKnown = !provider.isTracing(); });
    core::Case other = session;
    other.shown().frame = session.shown().frame == 0 ? 1 : 0;
    provider.setCase(other);
    provider.setCase(session);   // already traced, hence immediate
    ASSERT_TRUE(isReady(provider));
    EXPECT_TRUE(isKnown);
}

}   // namespace
}   // namespace angiopose::app
