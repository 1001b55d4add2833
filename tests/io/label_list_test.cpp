#include "io/label_list.h"

#include "io/vessel_input_file.h"
#include "io/volume_file.h"
#include "tests/support/forked_vessel.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cstring>

using namespace angiopose;

namespace {

using io::LabelInfo;
using test::TemporaryFolder;

std::vector<LabelInfo> named(std::initializer_list<const char*> names)
{
    std::vector<LabelInfo> labels;
    for (const char* name : names) {
        labels.push_back({static_cast<int>(labels.size()) + 1, name, 10, 0.1});
    }
    return labels;
}

TEST(LabelList, CountsVoxelsAndVolume)
{
    const auto listed = io::listLabels(test::forkLabels(), {{7, "box"}});
    ASSERT_EQ(listed.size(), 2U);
    EXPECT_EQ(listed[0].label, 2);
    EXPECT_EQ(listed[0].name, "");
    EXPECT_NEAR(listed[0].volumeMl, 1e-3 * static_cast<double>(listed[0].voxels), 1e-12) << "voxels of 1 mm";
    EXPECT_EQ(listed[1], (LabelInfo{7, "box", 5 * 64 * 96, 0.001 * 5 * 64 * 96}));
}

TEST(LabelList, ReadsTheLabelTableOfNifti)
{
    ANGIOPOSE_NEEDS_DATA("thoracic-aorta-cta");
    const auto names = io::readLabelNames(test::dataFile("thoracic-aorta-cta/T710_renal.nii.gz").string());
    EXPECT_EQ(
        names,
        (io::LabelNames{
            {1, "celiac_trunk"}, {2, "superior_mesenteric_artery"}, {3, "renal_arteries"}, {4, "organ_aorta_T264"}}));
    EXPECT_TRUE(io::readLabelNames(test::dataFile("thoracic-aorta-cta/aorta.nii.gz").string()).empty());
}

TEST(LabelList, ReadsTheSegmentsOfSlicer)
{
    const TemporaryFolder folder;
    const std::string path =
        folder.write("body.seg.nrrd",
                     "NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 2 2\n"
                     "space directions: (1,0,0) (0,1,0) (0,0,1)\nencoding: raw\nendian: little\nspace origin: (0,0,0)\n"
                     "Segment0_ID:=Segment_1\nSegment0_LabelValue:=3\nSegment0_Name:=Aorta\n"
                     "Segment1_ID:=Segment_2\nSegment1_LabelValue:=1\nSegment1_Name:=Left "
                     "kidney\n\n\x03\x01\x03\x01\x03\x01\x03\x01");
    EXPECT_EQ(io::readLabelNames(path), (io::LabelNames{{1, "Left kidney"}, {3, "Aorta"}}));
}

TEST(LabelList, NamesOfArteriesWinOverOrgansAndVeins)
{
    EXPECT_EQ(io::vesselLabelsByName(named({"liver", "aorta", "inferior_vena_cava", "iliac_artery_left"})),
              (std::vector<int>{2, 4}));
    EXPECT_EQ(io::vesselLabelsByName(named({"spleen", "portal_vein_and_splenic_vein"})), std::vector<int>{2});
    EXPECT_TRUE(io::vesselLabelsByName(named({"celiac_trunk", "organ_aorta_T264"})).empty())
        << "all: nothing to choose";
    EXPECT_TRUE(io::vesselLabelsByName(named({"", ""})).empty());
    EXPECT_EQ(io::vesselLabelsByName(named({"Aorta", "aortic valve", "Calcified plaque"})), std::vector<int>{1});
}

TEST(LabelList, FindsLabelsByNumberAndName)
{
    const auto labels = named({"liver", "Aorta"});
    const auto found = io::findLabels({"aorta", "1"}, labels);
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(found.value(), (std::vector<int>{2, 1}));
    const auto missing = io::findLabels({"spleen"}, labels);
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().message.text().find("1 liver, 2 Aorta"), std::string::npos) << missing.error().message;
}

/// Label list in which the bifurcating vessel is named as an artery and the box as an organ.
std::string namedFork(const TemporaryFolder& folder)
{
    const std::string plain = folder.file("plain.nrrd");
    EXPECT_TRUE(io::writeLabels(test::forkLabels(), plain));
    std::string content = test::readText(plain);
    const std::size_t headEnd = content.find("\n\n") + 1;
    content.insert(headEnd,
                   "Segment0_ID:=a\nSegment0_LabelValue:=7\nSegment0_Name:=liver\n"
                   "Segment1_ID:=b\nSegment1_LabelValue:=2\nSegment1_Name:=hepatic artery\n");
    return folder.write("fork.seg.nrrd", content);
}

TEST(LabelList, OverviewTellsWhereEachLabelLies)
{
    const TemporaryFolder folder;
    const auto read = io::readLabelOverview(namedFork(folder));
    ASSERT_TRUE(read) << read.error().message;
    const io::LabelOverview& overview = read.value();
    ASSERT_EQ(overview.labels.size(), 2U);
    EXPECT_EQ(overview.labels[0].name, "hepatic artery");
    EXPECT_EQ(overview.rows.rows.at(32, 18, 26), 1) << "in the trunk";
    EXPECT_EQ(overview.rows.rows.at(32, 38, 26), 2) << "in the box";
    EXPECT_LT(test::distanceToFork(overview.rows.centersInPatient[0]), 4.0);
    EXPECT_FALSE(io::readLabelOverview(folder.file("nowhere.nrrd")));
}

TEST(LabelList, TracingTakesTheVesselsAndSaysSo)
{
    const TemporaryFolder folder;
    core::VesselInput input;
    input.kind = core::VesselInputKind::Segmentation;
    const auto traced = io::readVessels(namedFork(folder), input);
    ASSERT_TRUE(traced) << traced.error().message;
    EXPECT_EQ(traced.value().input.labels, std::vector<int>{2});
    EXPECT_EQ(test::endsOf(traced.value().tree), 3);
    ASSERT_EQ(traced.value().warnings.size(), 2U);
    EXPECT_EQ(traced.value().warnings[0].text(), "Labels traced: 2 hepatic artery.");
    EXPECT_EQ(traced.value().warnings[1].text(), "Labels skipped because of their names: 7 liver.");
}

TEST(LabelList, TracingRefusesALabelThatIsNotThere)
{
    const TemporaryFolder folder;
    core::VesselInput input;
    input.kind = core::VesselInputKind::Segmentation;
    input.labels = {5};
    const auto traced = io::readVessels(namedFork(folder), input);
    ASSERT_FALSE(traced);
    EXPECT_NE(traced.error().message.text().find("5. Choose one of the available labels: 2 hepatic artery, 7 liver"),
              std::string::npos)
        << traced.error().message;
}

/// The labels of the bifurcating vessel as floats, some of them with rounding errors.
TEST(LabelList, LabelsStoredAsFloatAreLabels)
{
    const TemporaryFolder folder;
    const core::LabelVolume labels = test::forkLabels();
    std::vector<float> values(labels.voxels.begin(), labels.voxels.end());
    const auto written = [&] {
        const core::VolumeGeometry& grid = labels.geometry;
        const auto triple = [](const auto& v) {
            return std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z());
        };
        std::string bytes(values.size() * sizeof(float), '\0');
        std::memcpy(bytes.data(), values.data(), bytes.size());
        return folder.write("fork.mha", "ObjectType = Image\nNDims = 3\nOffset = " + triple(grid.originInPatient) +
                                            "\nElementSpacing = " + triple(grid.spacingMm) +
                                            "\nDimSize = " + triple(grid.size) +
                                            "\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n" + bytes);
    };
    for (const float factor : {1.0F, 0.9999999F}) {
        std::ranges::transform(labels.voxels, values.begin(),
                               [factor](std::uint16_t label) { return factor * static_cast<float>(label); });
        const auto listed = io::listLabelsOfFile(written());
        ASSERT_TRUE(listed) << factor;
        ASSERT_EQ(listed->size(), 2U);
        EXPECT_EQ((*listed)[1].voxels, io::listLabels(labels, {})[1].voxels);
        const auto image = io::readLabels(folder.file("fork.mha"));
        ASSERT_TRUE(image) << image.error().message;
        EXPECT_EQ(image.value().voxels, labels.voxels) << factor;
        const auto volume = io::readVolume(folder.file("fork.mha"));
        ASSERT_TRUE(volume);
        EXPECT_TRUE(io::looksLikeLabels(volume.value().volume)) << factor;
    }
    values[values.size() / 2] = 0.4F;
    const auto refused = io::readLabels(written());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.text().find("the value 0.4"), std::string::npos) << refused.error().message;
}

}   // namespace
