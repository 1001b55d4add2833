#include "app/jobs/load_job.h"

#include "app/jobs/input_kind.h"
#include "io/volume_file.h"
#include "tests/io/series/dicom_slices.h"
#include "tests/support/forked_vessel.h"
#include "tests/support/patience.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <QCoreApplication>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QThreadPool>

#include <algorithm>

namespace angiopose::app {
namespace {

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

constexpr const char* straightTree = "x,y,z,radius,branch\n0,0,0,1,0\n10,0,0,1,0\n20,0,0,1,0\n";

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

    ASSERT_TRUE(finished.wait(test::patienceMs));
    ASSERT_TRUE(inputs && inputs->wholeCase);
    EXPECT_EQ(inputs->wholeCase->title, "Coronary phantom, view IM4");
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

TEST(LoadJob, RefusesTwoTreesAtOnce)
{
    const QTemporaryDir folder;
    const auto inputs = readInputs({written(folder, "a.csv", straightTree), written(folder, "b.csv", straightTree)});

    ASSERT_FALSE(inputs);
    EXPECT_NE(inputs.error().message.text().find("b.csv"), std::string::npos);
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

TEST(LoadJob, TracesALabelImage)
{
    const QTemporaryDir folder;
    const QString mask = folder.filePath(QStringLiteral("mask.nrrd"));
    core::LabelVolume labels = test::forkLabels();
    std::replace(labels.voxels.begin(), labels.voxels.end(), std::uint16_t{7}, std::uint16_t{0});
    ASSERT_TRUE(io::writeLabels(labels, mask.toStdString()));

    const auto inputs = readInputs({mask});

    ASSERT_TRUE(inputs) << inputs.error().message;
    ASSERT_TRUE(inputs.value().tree);
    EXPECT_EQ(test::endsOf(*inputs.value().tree), 3);
    EXPECT_EQ(inputs.value().vesselInput.kind, core::VesselInputKind::Segmentation);
    EXPECT_EQ(inputs.value().centerlineFile.sha256.size(), 64U);
}

TEST(LoadJob, OffersTheSeriesOfAFolderAndOpensTheChosenOne)
{
    const QTemporaryDir folder;
    for (const char* series : {"1.2.3", "1.2.4"}) {
        for (int k = 0; k < 4; ++k) {
            test::CtSlice slice;
            slice.seriesUid = series;
            slice.sopInstanceUid = std::string(series) + "." + std::to_string(k);
            slice.position = {0, 0, 2.0 * k};
            slice.pixels.assign(72, 0);
            written(folder, (std::string(series) + std::to_string(k)).c_str(),
                    QByteArray::fromStdString(test::ctSlice(slice)));
        }
    }
    const auto offered = readInputs({folder.path()});
    ASSERT_TRUE(offered) << offered.error().message;
    EXPECT_EQ(offered.value().offered.size(), 2U);
    EXPECT_FALSE(offered.value().tree);

    const auto chosen = readInputs({folder.path()}, {QStringLiteral("1.2.4"), {}, {}});

    ASSERT_FALSE(chosen) << "an empty scan holds no vessels";
    EXPECT_NE(chosen.error().message.text().find(folder.path().toStdString()), std::string::npos);
}

TEST(LoadJob, SaysWhyOfEverySeriesWhereNoneCanBeOpened)
{
    const QTemporaryDir folder;
    const auto add = [&folder](const char* uid, const char* description, const std::vector<double>& position) {
        static int count = 0;
        test::CtSlice slice;
        slice.seriesUid = uid;
        slice.sopInstanceUid = std::string(uid) + "." + std::to_string(++count);
        slice.description = description;
        slice.position = position;
        slice.pixels.assign(72, 0);
        written(folder, slice.sopInstanceUid.c_str(), QByteArray::fromStdString(test::ctSlice(slice)));
    };
    add("1.2.3", "Scout", {0, 0, 0});
    add("1.2.5", "Topogram", {0, 0, 7});
    add("1.2.4", "Montage", {});
    const auto inputs = readInputs({folder.path()});
    ASSERT_FALSE(inputs);
    const std::string why = inputs.error().message.text();
    EXPECT_NE(why.find("none of its 3 series"), std::string::npos) << why;
    EXPECT_NE(why.find("Montage: its images do not say where"), std::string::npos) << why;
    EXPECT_TRUE(why.find("Scout, Topogram: it is a single slice") != std::string::npos ||
                why.find("Topogram, Scout: it is a single slice") != std::string::npos)
        << why;
}

TEST(LoadJob, StopsReadingWhenTheObserverSaysSo)
{
    const QTemporaryDir folder;
    const QString mask = folder.filePath(QStringLiteral("mask.nii.gz"));
    ASSERT_TRUE(io::writeLabels(test::forkLabels(), mask.toStdString()));
    const auto stopped = readInputs({mask}, {}, [](double) { return core::Verdict::Stop; });
    ASSERT_FALSE(stopped);
    EXPECT_TRUE(stopped.isStopped());
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
    EXPECT_EQ(kindOf("bare.csv", "7.83e+01,-2.03e+02,1.67e+03\n7.82e+01,-2.03e+02,1.67e+03\n"), InputKind::Centerline);
    EXPECT_EQ(kindOf("curve.csv", "x,y,branch\n1,2,0\n"), InputKind::Target);
    EXPECT_EQ(kindOf("IM1", QByteArray(128, '\0') + "DICM"), InputKind::Image);
    EXPECT_EQ(kindOf("oddly.named", "# vtk DataFile Version 3.0\n"), InputKind::Centerline);
    EXPECT_EQ(kindOf("picture.dat", "\x89PNG\r\n\x1a\n"), InputKind::Image);
}

TEST(InputKind, SaysWhatCanBeOpenedInsteadOfAStrangeFile)
{
    const QTemporaryDir folder;
    for (const char* name : {"brain.nii.gz", "notes.txt"}) {
        const auto kind = inputKindOf(written(folder, name, "something"));
        ASSERT_FALSE(kind);
        EXPECT_NE(kind.error().message.text().find(name), std::string::npos);
        EXPECT_NE(kind.error().message.text().find("VTP"), std::string::npos);
    }
    EXPECT_FALSE(inputKindOf(written(folder, "empty.png", "")));
    EXPECT_EQ(inputKindOf(folder.path()).value(), InputKind::Folder);
    EXPECT_EQ(inputKindOf(written(folder, "model.stl", "something")).value(), InputKind::Vessels);
}

}   // namespace
}   // namespace angiopose::app