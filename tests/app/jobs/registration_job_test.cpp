#include "app/jobs/registration_job.h"

#include "tests/app/jobs/small_case.h"
#include "tests/support/patience.h"
#include "tests/support/simulated_views.h"

#include <gtest/gtest.h>
#include <QCoreApplication>
#include <QSignalSpy>
#include <QThread>

#include <memory>

namespace angiopose::app {
namespace {

/// A registration that takes far too long to wait for: only a stop request ends it.
core::Case longRun()
{
    core::Case values = test::caseOf(test::smallCase());
    values.options.method = "iterative-pnp";
    values.options.maxIterations = 1000;
    return values;
}

TEST(RegistrationJob, DeliversTheResultOfTheSolver)
{
    const auto simulated = test::smallCase();
    RegistrationJob job;
    core::RegistrationResult result;
    QObject::connect(&job, &RegistrationJob::finished, [&](const core::RegisteredCase& r) { result = r.result(); });
    QSignalSpy finished(&job, &RegistrationJob::finished);

    job.start(test::caseOf(simulated), {});

    ASSERT_TRUE(finished.wait(test::patienceMs));
    const auto expected = core::registerCase(test::caseOf(simulated));
    ASSERT_TRUE(expected);
    EXPECT_TRUE(result.cameraFromPatient.matrix() == expected.value().result().cameraFromPatient.matrix());
    EXPECT_FALSE(job.isRunning());
}

TEST(RegistrationJob, KeepsTheBestPoseAfterAStop)
{
    RegistrationJob job;
    core::RegistrationResult result;
    QObject::connect(&job, &RegistrationJob::finished, [&](const core::RegisteredCase& r) { result = r.result(); });
    QObject::connect(&job, &RegistrationJob::progressed, &job, &RegistrationJob::requestStop);
    QSignalSpy finished(&job, &RegistrationJob::finished);

    job.start(longRun(), {});

    ASSERT_TRUE(finished.wait(test::patienceMs));
    EXPECT_TRUE(core::isRigid(result.cameraFromPatient));
    EXPECT_GT(result.metrics.coverage, 0.0);
}

TEST(RegistrationJob, ReportsStoppedWhenStoppedAtOnce)
{
    RegistrationJob job;
    core::RegistrationResult result;
    QObject::connect(&job, &RegistrationJob::finished, [&](const core::RegisteredCase& r) { result = r.result(); });
    QSignalSpy finished(&job, &RegistrationJob::finished);

    core::Case values = longRun();
    core::Centerline2d target = *values.shown().target.centerline;
    job.start(std::move(values), {core::RegistrationPlan::Views::Shown, std::move(target)});
    job.requestStop();

    ASSERT_TRUE(finished.wait(test::patienceMs));
    EXPECT_EQ(result.stopReason, core::StopReason::StoppedByUser);
}

TEST(RegistrationJob, ReportsProgressOnTheThreadOfItsOwner)
{
    RegistrationJob job;
    int reports = 0;
    bool sameThread = true;
    QObject::connect(&job, &RegistrationJob::progressed, [&] {
        ++reports;
        sameThread = sameThread && QThread::currentThread() == QCoreApplication::instance()->thread();
    });
    QSignalSpy finished(&job, &RegistrationJob::finished);

    job.start(test::caseOf(test::smallCase()), {});

    ASSERT_TRUE(finished.wait(test::patienceMs));
    EXPECT_GT(reports, 0);
    EXPECT_TRUE(sameThread);
}

TEST(RegistrationJob, SaysThatItsPoseIsOfTheShownViewAndNeverFallsBack)
{
    core::Case values = test::twoViewCase();
    values.shownView = 1;   // not the first view, and not part of a joint registration
    RegistrationJob job;
    int others = 0;
    double last = 0.0;
    bool hasFallen = false;
    QObject::connect(&job, &RegistrationJob::progressed, [&](const RunReport& report) {
        others += report.isOfShownView ? 0 : 1;
        hasFallen = hasFallen || report.iteration.progress < last;
        last = report.iteration.progress;
    });
    QSignalSpy finished(&job, &RegistrationJob::finished);

    job.start(values, {core::RegistrationPlan::Views::Shown});

    ASSERT_TRUE(finished.wait(test::patienceMs));
    EXPECT_EQ(others, 0);
    EXPECT_FALSE(hasFallen);
    EXPECT_GT(last, 0.0);
}

TEST(RegistrationJob, FailsOnUnusableInputWithWords)
{
    RegistrationJob job;
    QSignalSpy failed(&job, &RegistrationJob::failed);

    job.start({}, {});

    ASSERT_TRUE(failed.wait(test::patienceMs));
    const auto* reason = static_cast<const core::Message*>(failed.first().first().constData());
    EXPECT_FALSE(reason->text().empty());
    EXPECT_FALSE(job.isRunning());
}

TEST(RegistrationJob, CanBeDestroyedWhileRunning)
{
    auto job = std::make_unique<RegistrationJob>();
    int late = 0;
    QObject::connect(job.get(), &RegistrationJob::finished, [&] { ++late; });
    job->start(longRun(), {});
    QThread::msleep(20);

    job.reset();
    QCoreApplication::processEvents();

    EXPECT_EQ(late, 0);
}

}   // namespace
}   // namespace angiopose::app
