#include "app/jobs/load_job.h"

#include "app/jobs/input_kind.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <QCoreApplication>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QThreadPool>

namespace app {
namespace {

constexpr int patienceMs = 60000;

QString dataPath(const char* relative)
{
    return QString::fromStdString(test::dataFile(relative).string());
}

QString written(const QTemporaryDir& folder, const char* name, const QByteArray& content)
{
    const QString path = folder.filePath(QString::fromLatin1(name));
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(content);
    return path;
}

constexpr const char* straightTree = "x,y,z,radius,branch\n0,0,0,1,0\n1,0,0,1,0\n2,0,0,1,0\n";

TEST(LoadJob, ReadsTreeAndImageInAnyOrder)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/tree/Centerlines.vtk");
    const QString tree = dataPath("coronary-phantom-xa/tree/Centerlines.vtk");
    const QString image = dataPath("coronary-phantom-xa/views-A/IM4.dcm");
    for (const QStringList& paths : {QStringList{tree, image}, QStringList{image, tree}}) {
        const auto inputs = readInputs(paths);
        ASSERT_TRUE(inputs) << inputs.error().message;
        EXPECT_EQ(inputs.value().tree->branches.size(), 11U);
        EXPECT_EQ(inputs.value().angiogram->frameCount(), 10);
        EXPECT_EQ(inputs.value().imageFile.sha256.size(), 64U);
    }
}

TEST(LoadJob, DeliversACaseOnTheThreadOfItsOwner)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases/IM4.angiopose");
    LoadJob job;
    std::optional<LoadedInputs> inputs;
    QObject::connect(&job, &LoadJob::finished, [&](const LoadedInputs& i) { inputs = i; });
    QSignalSpy finished(&job, &LoadJob::finished);

    job.start({dataPath("coronary-phantom-xa/cases/IM4.angiopose")});

    ASSERT_TRUE(finished.wait(patienceMs));
    ASSERT_TRUE(inputs && inputs->wholeCase);
    EXPECT_EQ(inputs->wholeCase->title, "Coronary phantom, view IM4");
}

TEST(LoadJob, NamesTheFileThatIsMissing)
{
    LoadJob job;
    QSignalSpy failed(&job, &LoadJob::failed);

    job.start({QStringLiteral("/nowhere/tree.vtp")});

    ASSERT_TRUE(failed.wait(patienceMs));
    EXPECT_TRUE(failed.first().first().toString().contains(QStringLiteral("tree.vtp")));
}

TEST(LoadJob, RefusesTwoTreesAtOnce)
{
    const QTemporaryDir folder;
    const auto inputs = readInputs({written(folder, "a.csv", straightTree), written(folder, "b.csv", straightTree)});

    ASSERT_FALSE(inputs);
    EXPECT_NE(inputs.error().message.find("b.csv"), std::string::npos);
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

TEST(InputKind, IsToldByContentBeforeName)
{
    const QTemporaryDir folder;
    const auto kindOf = [&folder](const char* name, const QByteArray& content) {
        const auto kind = inputKindOf(written(folder, name, content));
        EXPECT_TRUE(kind);
        return kind ? kind.value() : InputKind::Case;
    };
    EXPECT_EQ(kindOf("tree.csv", straightTree), InputKind::Centerline);
    EXPECT_EQ(kindOf("curve.csv", "x,y,branch\n1,2,0\n"), InputKind::Target);
    EXPECT_EQ(kindOf("IM1", QByteArray(128, '\0') + "DICM"), InputKind::Image);
    EXPECT_EQ(kindOf("oddly.named", "# vtk DataFile Version 3.0\n"), InputKind::Centerline);
    EXPECT_EQ(kindOf("picture.dat", "\x89PNG\r\n\x1a\n"), InputKind::Image);
}

TEST(InputKind, SaysWhatCanBeOpenedInsteadOfAStrangeFile)
{
    const QTemporaryDir folder;
    for (const char* name : {"brain.nii.gz", "model.stl", "notes.txt"}) {
        const auto kind = inputKindOf(written(folder, name, "something"));
        ASSERT_FALSE(kind);
        EXPECT_NE(kind.error().message.find(name), std::string::npos);
        EXPECT_NE(kind.error().message.find("VTP"), std::string::npos);
    }
    EXPECT_FALSE(inputKindOf(written(folder, "empty.png", "")));
    EXPECT_FALSE(inputKindOf(folder.path()));
}

}   // namespace
}   // namespace app
