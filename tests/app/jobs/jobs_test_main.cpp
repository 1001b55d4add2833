#include <gtest/gtest.h>
#include <QCoreApplication>
#include <QThreadPool>

// Runs the job tests with an event loop but without any window, so that they can run under the thread sanitizer.
int main(int argc, char** argv)
{
    ::testing::InitGoogleTest(&argc, argv);
    const QCoreApplication application(argc, argv);
    // Every task has a thread of its own: one that waits, or has just ended another, is handed the next by Qt, which is
    // not instrumented, so that what the task holds would seem to be read without a lock.
    QThreadPool::globalInstance()->setExpiryTimeout(0);
    QThreadPool::globalInstance()->setMaxThreadCount(64);
    const int failures = RUN_ALL_TESTS();
    QThreadPool::globalInstance()->waitForDone();
    return failures;
}
