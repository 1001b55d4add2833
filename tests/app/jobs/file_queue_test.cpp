#include "app/jobs/file_queue.h"

#include <gtest/gtest.h>
#include <QSemaphore>
#include <QTest>
#include <QThread>

#include <memory>
#include <stdexcept>

namespace angiopose::app {
namespace {

TEST(FileQueue, WorksOffTheCallersThreadInTheOrderOfAsking)
{
    FileQueue queue;
    QStringList written;
    for (int i = 0; i < 5; ++i) {
        queue.run(
            [i, caller = QThread::currentThread()]() -> core::Result<QString> {
                EXPECT_NE(QThread::currentThread(), caller);
                return QString::number(i);
            },
            [&written](const core::Result<QString>& path) { written << path.value(); });
    }
    EXPECT_TRUE(queue.isBusy());
    ASSERT_TRUE(QTest::qWaitFor([&queue] { return !queue.isBusy(); }, 20000));
    EXPECT_EQ(written.join(QString()), QStringLiteral("01234"));
}

TEST(FileQueue, ReportsWhatALibraryThrows)
{
    FileQueue queue;
    QString message;
    queue.run([]() -> core::Result<QString> { throw std::runtime_error("disk on fire"); },
              [&message](const core::Result<QString>& path) {
                  message = QString::fromStdString(path ? std::string() : path.error().message.text());
              });
    ASSERT_TRUE(QTest::qWaitFor([&queue] { return !queue.isBusy(); }, 20000));
    EXPECT_TRUE(message.contains(QStringLiteral("disk on fire")));
}

TEST(FileQueue, FinishesWhatWasAskedForBeforeItGoes)
{
    QSemaphore gate;
    int done = 0;
    auto queue = std::make_unique<FileQueue>();
    for (int i = 0; i < 3; ++i) {
        queue->run(
            [&gate, &done]() -> core::Result<QString> {
                gate.acquire();
                ++done;
                return QString();
            },
            [](const core::Result<QString>&) { FAIL() << "nobody is left to be notified"; });
    }
    gate.release(3);
    queue.reset();
    EXPECT_EQ(done, 3);
}

}   // namespace
}   // namespace angiopose::app
