#include "app/editing/treated_run_cache.h"

#include <gtest/gtest.h>

namespace angiopose::app {
namespace {

using SharedRun = TreatedRunCache::SharedRun;

core::RunProcessing shiftedBy(double px)
{
    core::RunProcessing processing;
    processing.isSubtracted = true;
    processing.plan.maskShiftPx = Eigen::Vector2d(px, 0.0);
    return processing;
}

SharedRun run()
{
    return std::make_shared<const core::Angiogram>();
}

TEST(TreatedRunCache, KeepsTheNewestThreeAlive)
{
    TreatedRunCache runs;
    const SharedRun stored = run();
    for (int i = 0; i < 5; ++i) {
        runs.remember(stored, shiftedBy(i), run());
    }
    EXPECT_FALSE(runs.find(stored, shiftedBy(0)));
    EXPECT_FALSE(runs.find(stored, shiftedBy(1)));
    EXPECT_TRUE(runs.find(stored, shiftedBy(2)));
    EXPECT_TRUE(runs.find(stored, shiftedBy(4)));
    EXPECT_FALSE(runs.find(run(), shiftedBy(4)));
}

TEST(TreatedRunCache, FindsAnOldOneThatTheHistoryOfUndoKeeps)
{
    TreatedRunCache runs;
    const SharedRun stored = run();
    const SharedRun inHistory = run();
    runs.remember(stored, shiftedBy(9), inHistory);
    for (int i = 0; i < 5; ++i) {
        runs.remember(stored, shiftedBy(i), run());
    }
    EXPECT_EQ(runs.find(stored, shiftedBy(9)), inHistory);
}

TEST(TreatedRunCache, LetsGoOfAnotherCase)
{
    TreatedRunCache runs;
    const SharedRun stored = run();
    std::weak_ptr<const core::Angiogram> made;
    {
        const SharedRun one = run();
        made = one;
        runs.remember(stored, shiftedBy(1), one);
    }
    runs.retainOnly(stored);
    EXPECT_FALSE(made.expired());
    runs.retainOnly(run());
    EXPECT_TRUE(made.expired());
}

}   // namespace
}   // namespace angiopose::app
