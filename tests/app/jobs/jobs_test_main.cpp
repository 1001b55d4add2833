#include <gtest/gtest.h>
#include <QCoreApplication>
#include <QThreadPool>

// Runs the job tests with an event loop but without a window, for use with the thread sanitizer.
int main(int argc, char** argv)
{
    ::testing::InitGoogleTest(&argc, argv);
    const QCoreApplication application(argc, argv);
    // Every task gets a new thread. Qt, which is not instrumented, would hand the next task to a thread that is idle or
    // has just finished; the sanitizer would then report the task's data as read without a lock.
    QThreadPool::globalInstance()->setExpiryTimeout(0);
    QThreadPool::globalInstance()->setMaxThreadCount(64);
    const int failures = RUN_ALL_TESTS();
    QThreadPool::globalInstance()->waitForDone();
    return failures;
}
