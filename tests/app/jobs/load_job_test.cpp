#include "app/jobs/load_job.h"

#include "tests/support/patience.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <QCoreApplication>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QThreadPool>

namespace angiopose::app {
namespace {

QString written(const QTemporaryDir& folder, const char* name, const QByteArray& content)
{
    const QString path = folder.filePath(QString::fromLatin1(name));
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(content);
    return path;
}

constexpr const char* straightTree = "x,y,z,radius,branch\n0,0,0,1,0\n10,0,0,1,0\n20,0,0,1,0\n";

TEST(LoadJob, DeliversACaseOnTheThreadOfItsOwner)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases/IM4.angiopose");
    LoadJob job;
    std::optional<io::LoadedInputs> inputs;
    QObject::connect(&job, &LoadJob::finished, [&](const io::LoadedInputs& i) { inputs = i; });
    QSignalSpy finished(&job, &LoadJob::finished);

    job.start({QString::fromStdString(test::dataFile("coronary-phantom-xa/cases/IM4.angiopose").string())});

    ASSERT_TRUE(finished.wait(test::patienceMs));
    ASSERT_TRUE(inputs && inputs->loadedCase);
    EXPECT_EQ(inputs->loadedCase->title, "Coronary phantom, view IM4");
}

TEST(LoadJob, NamesTheFileThatIsMissing)
{
    LoadJob job;
    QSignalSpy failed(&job, &LoadJob::failed);

    job.start({QStringLiteral("/nowhere/tree.vtp")});

    ASSERT_TRUE(failed.wait(test::patienceMs));
    const auto* reason = static_cast<const core::Message*>(failed.first().first().constData());
    EXPECT_NE(reason->text().find("tree.vtp"), std::string::npos);
}

TEST(LoadJob, DropsWhatItReadsWhenAbandoned)
{
    const QTemporaryDir folder;
    LoadJob job;
    QSignalSpy finished(&job, &LoadJob::finished);
    QSignalSpy failed(&job, &LoadJob::failed);
    job.start({written(folder, "a.csv", straightTree)});

    job.abandon();
    QThreadPool::globalInstance()->waitForDone();
    QCoreApplication::processEvents();

    EXPECT_EQ(finished.count() + failed.count(), 0);
    EXPECT_FALSE(job.isRunning());
}

}   // namespace
}   // namespace angiopose::app
