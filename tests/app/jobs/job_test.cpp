#include "app/jobs/job.h"
#include "tests/app/wait_for.h"

#include <gtest/gtest.h>
#include <QCoreApplication>
#include <QTest>
#include <QThread>

#include <atomic>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace angiopose::app {
namespace {

using Link = JobLink<int>;

struct HeardJob {
    std::vector<int> reports;
    std::vector<std::string> found;
    std::vector<std::string> problems;
    Job<std::string, int> job{{[this](const std::string& text) { found.push_back(text); },
                               [this](const core::Error& error) { problems.push_back(error.message.text()); },
                               [this](int report) { reports.push_back(report); }}};

    bool waits()
    {
        return test::waitFor([this] { return !job.isRunning(); });
    }
};

core::Result<std::string> untilStopped(Link& link)
{
    for (int step = 0; link.tell(step) != core::ObserverDecision::Stop; ++step) {
        QThread::msleep(1);
    }
    return std::string("stopped");
}

TEST(Job, TellsTheNewestReportAndOneOutcome)
{
    HeardJob heard;
    heard.job.start([](Link& link) -> core::Result<std::string> {
        for (int step = 0; step <= 1000; ++step) {
            link.tell(step);
        }
        return std::string("done");
    });
    EXPECT_TRUE(heard.job.isRunning());
    ASSERT_TRUE(heard.waits());
    EXPECT_EQ(heard.found, std::vector<std::string>{"done"});
    EXPECT_TRUE(heard.problems.empty());
    ASSERT_FALSE(heard.reports.empty());
    EXPECT_EQ(heard.reports.back(), 1000);
    EXPECT_LT(heard.reports.size(), 1000U);
}

TEST(Job, AnswersAStop)
{
    HeardJob heard;
    heard.job.start(untilStopped);
    heard.job.requestStop();
    ASSERT_TRUE(heard.waits());
    EXPECT_EQ(heard.found, std::vector<std::string>{"stopped"});
}

TEST(Job, TurnsWhatIsThrownIntoAnError)
{
    HeardJob heard;
    heard.job.start([](Link&) -> core::Result<std::string> { throw std::runtime_error("out of luck"); });
    ASSERT_TRUE(heard.waits());
    ASSERT_EQ(heard.problems.size(), 1U);
    EXPECT_NE(heard.problems[0].find("out of luck"), std::string::npos);
}

TEST(Job, SaysNothingOfWhatWasDropped)
{
    HeardJob heard;
    heard.job.start(untilStopped);
    heard.job.start([](Link&) -> core::Result<std::string> { return std::string("second"); });
    ASSERT_TRUE(heard.waits());
    QTest::qWait(50);
    EXPECT_EQ(heard.found, std::vector<std::string>{"second"});
    heard.job.start(untilStopped);
    heard.job.drop();
    EXPECT_FALSE(heard.job.isRunning());
    QTest::qWait(50);
    EXPECT_EQ(heard.found.size(), 1U);
}

TEST(Job, CanBeStartedAgainByWhoHearsItsEnd)
{
    int runs = 0;
    std::function<void()> again;
    Job<int> job([&](const int& found) {
        runs = found;
        if (found < 3) {
            again();
        }
    });
    again = [&] { job.start([next = runs + 1](JobLink<double>&) -> core::Result<int> { return next; }); };
    again();
    EXPECT_TRUE(test::waitFor([&] { return runs == 3; }));
}

TEST(Job, IsDestroyedWithoutWaiting)
{
    std::atomic<bool> isReleased{false};
    std::atomic<bool> hasEnded{false};
    {
        HeardJob heard;
        heard.job.start([&](Link&) -> core::Result<std::string> {
            while (!isReleased) {   // ignores the stop request
                QThread::msleep(1);
            }
            hasEnded = true;
            return std::string("late");
        });
    }
    EXPECT_FALSE(hasEnded);
    isReleased = true;
    EXPECT_TRUE(test::waitFor([&] { return hasEnded.load(); }));
}

}   // namespace
}   // namespace angiopose::app
