#include "app/jobs/evaluation_job.h"

#include "tests/app/jobs/small_case.h"
#include "tests/support/patience.h"

#include <gtest/gtest.h>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QThreadPool>

#include <chrono>

namespace angiopose::app {
namespace {

EvaluationRequest requestAt(const core::SimulatedCase& simulated, double shiftMm)
{
    core::RigidTransform pose = simulated.trueCameraFromPatient;
    pose.translation.x() += shiftMm;
    return {test::inputOf(simulated), pose};
}

TEST(EvaluationJob, FindsTheTruePoseFree)
{
    const auto simulated = test::smallCase();
    EvaluationJob job;
    SharedEvaluation evaluation;
    QObject::connect(&job, &EvaluationJob::evaluated, [&](const SharedEvaluation& j) { evaluation = j; });
    QSignalSpy evaluated(&job, &EvaluationJob::evaluated);

    job.request(requestAt(simulated, 0.0));

    ASSERT_TRUE(evaluated.wait(test::patienceMs));
    EXPECT_LT(evaluation->result.metrics.medianPx, 1.0);
    ASSERT_EQ(evaluation->residualPx.size(), simulated.tree.branches.size());
    const core::VesselBranch& branch = simulated.tree.branches.front();
    EXPECT_EQ(evaluation->residualPx.at(branch.id).size(), branch.pointsInPatient.size());
}

TEST(EvaluationJob, AnswersTheNewestRequestLast)
{
    const auto simulated = test::smallCase();
    EvaluationJob job;
    std::vector<double> medians;
    QObject::connect(&job, &EvaluationJob::evaluated,
                     [&](const SharedEvaluation& j) { medians.push_back(j->result.metrics.medianPx); });
    QSignalSpy evaluated(&job, &EvaluationJob::evaluated);

    for (int shift = 10; shift >= 0; --shift) {
        job.request(requestAt(simulated, 2.0 * shift));
    }

    while (medians.size() < 2 && evaluated.wait(test::patienceMs)) {
    }
    // The first request was already running; the last one replaced all those between.
    ASSERT_EQ(medians.size(), 2U);
    EXPECT_GT(medians.front(), medians.back());
    EXPECT_LT(medians.back(), 1.0);
}

TEST(EvaluationJob, RestsBetweenAnswersAndThenTakesTheNewest)
{
    const auto simulated = test::smallCase();
    constexpr auto rest = std::chrono::milliseconds(400);
    EvaluationJob job(rest);
    QElapsedTimer sinceFirst;
    std::vector<double> medians;
    std::vector<qint64> timesMs;
    QObject::connect(&job, &EvaluationJob::evaluated, [&](const SharedEvaluation& j) {
        if (medians.empty()) {
            sinceFirst.start();
            job.request(requestAt(simulated, 6.0));
            job.request(requestAt(simulated, 0.0));
        }
        medians.push_back(j->result.metrics.medianPx);
        timesMs.push_back(sinceFirst.elapsed());
    });
    QSignalSpy evaluated(&job, &EvaluationJob::evaluated);
    job.request(requestAt(simulated, 20.0));
    while (medians.size() < 2 && evaluated.wait(test::patienceMs)) {
    }
    ASSERT_EQ(medians.size(), 2U);
    EXPECT_LT(medians.back(), 1.0);
    EXPECT_GE(timesMs.back(), rest.count() - 20);
}

TEST(EvaluationJob, StaysSilentAfterCancel)
{
    const auto simulated = test::smallCase();
    EvaluationJob job;
    QSignalSpy evaluated(&job, &EvaluationJob::evaluated);
    job.request(requestAt(simulated, 0.0));
    job.request(requestAt(simulated, 1.0));

    job.cancel();
    QThreadPool::globalInstance()->waitForDone();
    QCoreApplication::processEvents();

    EXPECT_EQ(evaluated.count(), 0);
}

}   // namespace
}   // namespace angiopose::app
