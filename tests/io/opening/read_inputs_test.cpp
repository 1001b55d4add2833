#include "io/opening/read_inputs.h"
#include "io/opening/input_kind.h"
#include "io/volume_file.h"
#include "tests/io/series/dicom_slices.h"
#include "tests/support/forked_vessel.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace angiopose::io {
namespace {

std::string dataPath(const char* relative)
{
    return test::dataFile(relative).string();
}

constexpr const char* straightTable = "x,y,z,radius,branch\n0,0,0,1,0\n10,0,0,1,0\n20,0,0,1,0\n";

TEST(ReadInputs, ReadsTreeAndImageInAnyOrder)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/tree/Centerlines.vtk");
    const std::string tree = dataPath("coronary-phantom-xa/tree/Centerlines.vtk");
    const std::string image = dataPath("coronary-phantom-xa/views-A/IM4.dcm");
    for (const auto& paths : {std::vector{tree, image}, std::vector{image, tree}}) {
        const auto inputs = readInputs(paths);
        ASSERT_TRUE(inputs) << inputs.error().message;
        EXPECT_EQ(inputs.value().tree->branches.size(), 11U);
        EXPECT_EQ(inputs.value().angiogram->frameCount(), 10);
        EXPECT_EQ(inputs.value().imageFile.sha256.size(), 64U);
    }
}

TEST(ReadInputs, RefusesTwoTreesAtOnce)
{
    const test::TemporaryFolder folder;
    const auto inputs = readInputs({folder.write("a.csv", straightTable), folder.write("b.csv", straightTable)});

    ASSERT_FALSE(inputs);
    EXPECT_NE(inputs.error().message.text().find("b.csv"), std::string::npos);
}

TEST(ReadInputs, TracesALabelImage)
{
    const test::TemporaryFolder folder;
    const std::string mask = folder.file("mask.nrrd");
    core::LabelVolume labels = test::forkLabels();
    std::replace(labels.voxels.begin(), labels.voxels.end(), std::uint16_t{7}, std::uint16_t{0});
    ASSERT_TRUE(writeLabels(labels, mask));

    const auto inputs = readInputs({mask});

    ASSERT_TRUE(inputs) << inputs.error().message;
    ASSERT_TRUE(inputs.value().tree);
    EXPECT_EQ(test::endsOf(*inputs.value().tree), 3);
    EXPECT_EQ(inputs.value().vesselInput.kind, core::VesselInputKind::Segmentation);
    EXPECT_EQ(inputs.value().centerlineFile.sha256.size(), 64U);
}

TEST(ReadInputs, OffersTheSeriesOfAFolderAndOpensTheChosenOne)
{
    const test::TemporaryFolder folder;
    for (const char* series : {"1.2.3", "1.2.4"}) {
        for (int k = 0; k < 4; ++k) {
            test::CtSlice slice;
            slice.seriesUid = series;
            slice.sopInstanceUid = std::string(series) + "." + std::to_string(k);
            slice.position = {0, 0, 2.0 * k};
            slice.pixels.assign(72, 0);
            folder.write(std::string(series) + std::to_string(k), test::ctSlice(slice));
        }
    }
    const auto offeredSeries = readInputs({folder.file(".")});
    ASSERT_TRUE(offeredSeries) << offeredSeries.error().message;
    EXPECT_EQ(offeredSeries.value().offeredSeries.size(), 2U);
    EXPECT_FALSE(offeredSeries.value().tree);

    const auto chosen = readInputs({folder.file(".")}, {"1.2.4", {}, {}});

    ASSERT_FALSE(chosen) << "an empty scan holds no vessels";
    EXPECT_NE(chosen.error().message.text().find(folder.file(".")), std::string::npos);
}

TEST(ReadInputs, SaysWhyOfEverySeriesWhereNoneCanBeOpened)
{
    const test::TemporaryFolder folder;
    const auto add = [&folder](const char* uid, const char* description, const std::vector<double>& position) {
        static int count = 0;
        test::CtSlice slice;
        slice.seriesUid = uid;
        slice.sopInstanceUid = std::string(uid) + "." + std::to_string(++count);
        slice.description = description;
        slice.position = position;
        slice.pixels.assign(72, 0);
        folder.write(slice.sopInstanceUid, test::ctSlice(slice));
    };
    add("1.2.3", "Scout", {0, 0, 0});
    add("1.2.5", "Topogram", {0, 0, 7});
    add("1.2.4", "Montage", {});
    const auto inputs = readInputs({folder.file(".")});
    ASSERT_FALSE(inputs);
    const std::string why = inputs.error().message.text();
    EXPECT_NE(why.find("none of the 3 series"), std::string::npos) << why;
    EXPECT_NE(why.find("Montage: the images specify no position"), std::string::npos) << why;
    EXPECT_TRUE(why.find("Scout, Topogram: this is a single slice") != std::string::npos ||
                why.find("Topogram, Scout: this is a single slice") != std::string::npos)
        << why;
}

TEST(ReadInputs, StopsReadingWhenTheObserverSaysSo)
{
    const test::TemporaryFolder folder;
    const std::string mask = folder.file("mask.nii.gz");
    ASSERT_TRUE(writeLabels(test::forkLabels(), mask));
    const auto stopped = readInputs({mask}, {}, [](double) { return core::ObserverDecision::Stop; });
    ASSERT_FALSE(stopped);
    EXPECT_TRUE(stopped.isStopped());
}

TEST(InputKind, IsToldByContentBeforeName)
{
    const test::TemporaryFolder folder;
    const auto kindOf = [&folder](const char* name, const std::string& content) {
        const auto kind = inputKindOf(folder.write(name, content));
        EXPECT_TRUE(kind);
        return kind ? kind.value() : InputKind::Case;
    };
    EXPECT_EQ(kindOf("tree.csv", straightTable), InputKind::Centerline);
    EXPECT_EQ(kindOf("bare.csv", "7.83e+01,-2.03e+02,1.67e+03\n7.82e+01,-2.03e+02,1.67e+03\n"), InputKind::Centerline);
    EXPECT_EQ(kindOf("curve.csv", "x,y,branch\n1,2,0\n"), InputKind::Target);
    EXPECT_EQ(kindOf("IM1", std::string(128, '\0') + "DICM"), InputKind::Image);
    EXPECT_EQ(kindOf("oddly.named", "# vtk DataFile Version 3.0\n"), InputKind::Centerline);
    EXPECT_EQ(kindOf("picture.dat", "\x89PNG\r\n\x1a\n"), InputKind::Image);
}

TEST(InputKind, TellsPosesAndPointsFromCurves)
{
    const test::TemporaryFolder folder;
    const auto kindOf = [&folder](const char* name, const std::string& content) {
        return inputKindOf(folder.write(name, content)).value();
    };
    const std::string markups = R"({"markups": [{"type": "TYPE", "controlPoints": [{"position": [1, 2, 3]}]}]})";
    const auto markupsOf = [&](const std::string& type) {
        return std::string(markups).replace(markups.find("TYPE"), 4, type);
    };
    EXPECT_EQ(kindOf("curve.mrk.json", markupsOf("Curve")), InputKind::Centerline);
    EXPECT_EQ(kindOf("points.mrk.json", markupsOf("Fiducial")), InputKind::Points);
    EXPECT_EQ(kindOf("points.fcsv", "# CoordinateSystem = LPS\n"), InputKind::Points);
    EXPECT_EQ(kindOf("pose.json", R"({"cameraFromPatient": [[1]]})"), InputKind::Pose);
    EXPECT_EQ(kindOf("p.json", R"({"P": [1,0,0,0, 0,1,0,0, 0,0,1,700]})"), InputKind::Pose);
    EXPECT_EQ(kindOf("p.txt", "1 0 0 0\n0 1 0 0\n0 0 1 700\n"), InputKind::Pose);
    EXPECT_EQ(kindOf("camera.yml", "%YAML:1.0\n"), InputKind::Pose);
    EXPECT_EQ(kindOf("pose.tfm", "#Insight Transform File V1.0\n"), InputKind::Pose);
}

TEST(InputKind, SaysWhatCanBeOpenedInsteadOfAStrangeFile)
{
    const test::TemporaryFolder folder;
    for (const char* name : {"brain.nii.gz", "notes.txt"}) {
        const auto kind = inputKindOf(folder.write(name, "something"));
        ASSERT_FALSE(kind);
        EXPECT_NE(kind.error().message.text().find(name), std::string::npos);
        EXPECT_NE(kind.error().message.text().find("VTP"), std::string::npos);
    }
    EXPECT_FALSE(inputKindOf(folder.write("empty.png", "")));
    EXPECT_EQ(inputKindOf(folder.file(".")).value(), InputKind::Folder);
    EXPECT_EQ(inputKindOf(folder.write("model.stl", "something")).value(), InputKind::Vessels);
}

}   // namespace
}   // namespace angiopose::io
