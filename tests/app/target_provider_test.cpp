#include "app/registration/target_provider.h"

#include "core/simulation/simulated_case.h"
#include "tests/support/patience.h"

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
    return QTest::qWaitFor([&provider] { return provider.current() && !provider.isTracing(); }, test::patienceMs);
}

TEST(TargetProvider, RemembersTracesButKeepsNoRunAlive)
{
    TargetProvider provider;
    auto first = caseWith(simulatedRun());
    const auto second = caseWith(simulatedRun());
    const std::weak_ptr<const core::Angiogram> firstRun = first.shown().angiogram;
    provider.want(first);
    ASSERT_TRUE(isReady(provider));
    const SharedTrace traced = provider.trace();
    provider.want(second);
    ASSERT_TRUE(isReady(provider));

    provider.want(first);
    EXPECT_EQ(provider.trace(), traced);   // at once
    provider.want(second);
    first.shown().angiogram.reset();   // closed
    EXPECT_TRUE(firstRun.expired());
}

}   // namespace
}   // namespace angiopose::app