#include <gtest/gtest.h>
#include <QCoreApplication>
#include <QThreadPool>

// Runs the job tests with an event loop but without any window, so that they can run under the thread sanitizer.
int main(int argc, char** argv)
{
    ::testing::InitGoogleTest(&argc, argv);
    const QCoreApplication application(argc, argv);
    const int failures = RUN_ALL_TESTS();
    QThreadPool::globalInstance()->waitForDone();
    return failures;
}
