#include "app/jobs/judge_job.h"

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

JudgeRequest requestAt(const core::SimulatedCase& simulated, double shiftMm)
{
    core::RigidTransform pose = simulated.trueCameraFromPatient;
    pose.translation.x() += shiftMm;
    return {test::inputOf(simulated), pose};
}

TEST(JudgeJob, FindsTheTruePoseFree)
{
    const auto simulated = test::smallCase();
    JudgeJob job;
    SharedJudgement judgement;
    QObject::connect(&job, &JudgeJob::judged, [&](const SharedJudgement& j) { judgement = j; });
    QSignalSpy judged(&job, &JudgeJob::judged);

    job.request(requestAt(simulated, 0.0));

    ASSERT_TRUE(judged.wait(test::patienceMs));
    EXPECT_LT(judgement->result.metrics.medianPx, 1.0);
    ASSERT_EQ(judgement->residualPx.size(), simulated.tree.branches.size());
    const core::VesselBranch& branch = simulated.tree.branches.front();
    EXPECT_EQ(judgement->residualPx.at(branch.id).size(), branch.pointsInPatient.size());
}

TEST(JudgeJob, AnswersTheNewestRequestLast)
{
    const auto simulated = test::smallCase();
    JudgeJob job;
    std::vector<double> medians;
    QObject::connect(&job, &JudgeJob::judged,
                     [&](const SharedJudgement& j) { medians.push_back(j->result.metrics.medianPx); });
    QSignalSpy judged(&job, &JudgeJob::judged);

    for (int shift = 10; shift >= 0; --shift) {
        job.request(requestAt(simulated, 2.0 * shift));
    }

    while (medians.size() < 2 && judged.wait(test::patienceMs)) {
    }
    // The first request was already running; the last one replaced all those between.
    ASSERT_EQ(medians.size(), 2U);
    EXPECT_GT(medians.front(), medians.back());
    EXPECT_LT(medians.back(), 1.0);
}

TEST(JudgeJob, RestsBetweenAnswersAndThenTakesTheNewest)
{
    const auto simulated = test::smallCase();
    constexpr auto rest = std::chrono::milliseconds(400);
    JudgeJob job(rest);
    QElapsedTimer sinceFirst;
    std::vector<double> medians;
    std::vector<qint64> timesMs;
    QObject::connect(&job, &JudgeJob::judged, [&](const SharedJudgement& j) {
        if (medians.empty()) {
            sinceFirst.start();
            job.request(requestAt(simulated, 6.0));
            job.request(requestAt(simulated, 0.0));
        }
        medians.push_back(j->result.metrics.medianPx);
        timesMs.push_back(sinceFirst.elapsed());
    });
    QSignalSpy judged(&job, &JudgeJob::judged);
    job.request(requestAt(simulated, 20.0));
    while (medians.size() < 2 && judged.wait(test::patienceMs)) {
    }
    ASSERT_EQ(medians.size(), 2U);
    EXPECT_LT(medians.back(), 1.0);
    EXPECT_GE(timesMs.back(), rest.count() - 20);
}

TEST(JudgeJob, StaysSilentAfterCancel)
{
    const auto simulated = test::smallCase();
    JudgeJob job;
    QSignalSpy judged(&job, &JudgeJob::judged);
    job.request(requestAt(simulated, 0.0));
    job.request(requestAt(simulated, 1.0));

    job.cancel();
    QThreadPool::globalInstance()->waitForDone();
    QCoreApplication::processEvents();

    EXPECT_EQ(judged.count(), 0);
}

}   // namespace
}   // namespace angiopose::app
