#include "app/jobs/trace_job.h"

#include "tests/app/jobs/small_case.h"
#include "tests/support/patience.h"

#include <gtest/gtest.h>
#include <QSignalSpy>

#include <memory>

namespace angiopose::app {
namespace {

TEST(TraceJob, FindsTheVesselsOfTheFrame)
{
    const auto simulated = test::smallCase();
    TraceJob job;
    SharedTrace traced;
    QObject::connect(&job, &TraceJob::finished, [&](const SharedTrace& t) { traced = t; });
    QSignalSpy finished(&job, &TraceJob::finished);

    job.start({std::make_shared<core::Angiogram>(simulated.angiogram), simulated.angiogram.suggestedFrame, {}});

    ASSERT_TRUE(finished.wait(test::patienceMs));
    ASSERT_TRUE(traced);
    EXPECT_GT(traced->centerline.pointCount(), 50U);
}

TEST(TraceJob, SaysWhyAnEvenFrameCannotBeTraced)
{
    core::Angiogram flat;
    flat.frames.emplace_back(64, 64, 100.0F);
    TraceJob job;
    QSignalSpy failed(&job, &TraceJob::failed);

    job.start({std::make_shared<core::Angiogram>(flat), 0, {}});

    ASSERT_TRUE(failed.wait(test::patienceMs));
    const auto* reason = static_cast<const core::Message*>(failed.first().first().constData());
    EXPECT_FALSE(reason->text().empty());
}

TEST(TraceJob, CanBeDestroyedWhileRunning)
{
    const auto simulated = test::smallCase();
    auto job = std::make_unique<TraceJob>();
    job->start({std::make_shared<core::Angiogram>(simulated.angiogram), 0, {}});
    EXPECT_TRUE(job->isRunning());

    job.reset();
}

}   // namespace
}   // namespace angiopose::app
