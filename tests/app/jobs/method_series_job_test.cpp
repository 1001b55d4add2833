#include "app/jobs/method_series_job.h"

#include "tests/app/jobs/small_case.h"
#include "tests/app/wait_for.h"

#include <gtest/gtest.h>
#include <QSignalSpy>
#include <QTest>

namespace angiopose::app {
namespace {

struct HeardSeries {
    explicit HeardSeries(MethodSeriesJob& job)
    {
        QObject::connect(&job, &MethodSeriesJob::solved,
                         [this](const core::RegistrationResult& result) { methods.push_back(result.method); });
        QObject::connect(&job, &MethodSeriesJob::failed,
                         [this](const QString& id, const core::Message&) { failed.push_back(id.toStdString()); });
        QObject::connect(&job, &MethodSeriesJob::progressed, [this](const QString&, double progress) {
            isOrdered = isOrdered && progress >= last;
            last = progress;
        });
        QObject::connect(&job, &MethodSeriesJob::ended, [this](bool stopped) {
            ended = true;
            wasStopped = stopped;
        });
    }
    std::vector<std::string> methods;
    std::vector<std::string> failed;
    double last = 0.0;
    bool isOrdered = true;
    bool ended = false;
    bool wasStopped = false;
};

TEST(MethodSeriesJob, RunsEachMethodFromTheSameStartAndGoesOnAfterAFailure)
{
    MethodSeriesJob job;
    HeardSeries heard(job);
    job.start(test::inputOf(test::smallCase()), {}, {"angiopose", "no-such-method", "dt-icp"});
    EXPECT_TRUE(job.isRunning());
    ASSERT_TRUE(test::waitFor([&] { return heard.ended; }));

    EXPECT_EQ(heard.methods, (std::vector<std::string>{"angiopose", "dt-icp"}));
    EXPECT_EQ(heard.failed, std::vector<std::string>{"no-such-method"});
    EXPECT_FALSE(heard.wasStopped);
    EXPECT_TRUE(heard.isOrdered);
    EXPECT_FALSE(job.isRunning());
}

TEST(MethodSeriesJob, StopKeepsWhatIsFinishedAndSkipsTheRest)
{
    MethodSeriesJob job;
    HeardSeries heard(job);
    QObject::connect(&job, &MethodSeriesJob::solved, &job, [&job] { job.requestStop(); });
    job.start(test::inputOf(test::smallCase()), {}, {"angiopose", "particle", "evolution", "rgbr", "automask"});
    ASSERT_TRUE(test::waitFor([&] { return heard.ended; }));

    EXPECT_TRUE(heard.wasStopped);
    EXPECT_LT(heard.methods.size(), 5u);
    EXPECT_EQ(heard.methods.front(), "angiopose");
}

TEST(MethodSeriesJob, CanBeDestroyedWhileItRuns)
{
    bool wasHeard = false;
    {
        MethodSeriesJob job;
        QObject::connect(&job, &MethodSeriesJob::solved, [&wasHeard] { wasHeard = true; });
        job.start(test::inputOf(test::smallCase()), {}, {"particle", "evolution"});
    }
    QTest::qWait(20);
    EXPECT_FALSE(wasHeard);
}

}   // namespace
}   // namespace angiopose::app
