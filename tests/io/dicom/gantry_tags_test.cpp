#include "io/dicom/gantry_tags.h"

#include "core/case/case.h"
#include "tests/io/phantom_view.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <algorithm>

using namespace angiopose;

namespace {

/// A data set with these elements in ascending order, as text.
io::DicomDataset headerWith(std::initializer_list<std::pair<io::DicomTag, const char*>> elements)
{
    std::string bytes;
    const auto add = [&](std::size_t number) {
        bytes += static_cast<char>(number & 0xff);
        bytes += static_cast<char>(number >> 8 & 0xff);
    };
    for (const auto& [tag, value] : elements) {
        add(tag >> 16);
        add(tag);
        bytes += "DS";
        add(std::string_view(value).size());
        bytes += value;
    }
    return io::readElements(bytes, io::DicomEncoding{});
}

std::string valueOf(const core::GantryHeader& header, const std::string& tag)
{
    const auto found = std::ranges::find(header.tags, tag, &core::HeaderTag::tag);
    return found == header.tags.end() ? "absent" : found->value;
}

}   // namespace

TEST(GantryHeader, ListsEveryGeometryTagOfThePhantom)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/views-A/IM1.dcm");
    for (int view = 1; view <= 4; ++view) {
        const core::GantryHeader header = test::phantomView(view).gantry;
        EXPECT_EQ(valueOf(header, "(0018,1111)"), "720");
        EXPECT_EQ(valueOf(header, "(0018,1164)"), "absent");
        EXPECT_EQ(valueOf(header, "(0018,1149)"), "200, 200");
        EXPECT_NE(valueOf(header, "(0018,1510)"), "absent");
        EXPECT_TRUE(std::ranges::is_sorted(header.tags, {}, &core::HeaderTag::tag));
        EXPECT_TRUE(header.angleIncrementsDeg.empty());
    }
}

/// The header's angles alone determine the rotation from view to view.
TEST(GantryHeader, AnglesGiveTheRelativeRotationOfEveryPairOfViewsExactly)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/views-A/IM1.dcm");
    std::vector<core::CArm> views;
    for (int view = 1; view <= 4; ++view) {
        views.push_back(test::phantomView(view).cArm);
    }
    const auto turned = [](double deg, const Eigen::Vector3d& axis) {
        return Eigen::AngleAxisd(deg * 3.14159265358979323846 / 180.0, axis).toRotationMatrix();
    };
    // Independent derivation of the same rotation: from the frontal view (x left on screen, y down, z to the detector),
    // the gantry moves along the longitude (about the patient's head axis), then along the latitude.
    const auto byHand = [&](const core::CArm& cArm) {
        Eigen::Matrix3d frontal;
        frontal << -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, -1.0, 0.0;
        const Eigen::Matrix3d longitude = turned(*cArm.primaryAngleDeg.value, Eigen::Vector3d::UnitZ());
        const Eigen::Matrix3d latitude = turned(-*cArm.secondaryAngleDeg.value, Eigen::Vector3d::UnitX());
        return Eigen::Matrix3d(frontal * (longitude * latitude).transpose());
    };
    for (std::size_t a = 0; a < views.size(); ++a) {
        for (std::size_t b = 0; b < views.size(); ++b) {
            const auto poseA = core::cameraFromPatient(views[a], {1, 2, 3}).value();
            const auto poseB = core::cameraFromPatient(views[b], {1, 2, 3}).value();
            const Eigen::Matrix3d relative = (poseB * poseA.inverse()).rotation;
            const Eigen::Matrix3d wanted = byHand(views[b]) * byHand(views[a]).transpose();
            EXPECT_LT((relative - wanted).norm(), 1e-12) << "views " << a + 1 << " and " << b + 1;
        }
    }
}

TEST(GantryHeader, IncrementsTurnTheAnglesOfEachFrame)
{
    core::Messages warnings;
    const auto header = io::gantryHeaderOf(
        headerWith({{0x00181500, "DYNAMIC"}, {0x00181520, "0\\1.5\\3"}, {0x00181521, "0\\0\\-2"}}), 3, warnings);
    EXPECT_TRUE(warnings.empty());
    ASSERT_EQ(header.angleIncrementsDeg.size(), 3U);
    EXPECT_EQ(header.angleIncrementsDeg[2], Eigen::Vector2d(3.0, -2.0));
    EXPECT_EQ(valueOf(header, "(0018,1520)"), "0, 1.5, 3");
}

TEST(GantryHeader, OneIncrementIsThatOfEveryFrame)
{
    core::Messages warnings;
    const auto header = io::gantryHeaderOf(headerWith({{0x00181520, "2.5"}}), 4, warnings);
    ASSERT_EQ(header.angleIncrementsDeg.size(), 4U);
    EXPECT_EQ(header.angleIncrementsDeg[3], Eigen::Vector2d(7.5, 0.0));
}

TEST(GantryHeader, MotionWithoutFittingIncrementsIsWarnedAbout)
{
    core::Messages warnings;
    EXPECT_TRUE(io::gantryHeaderOf(headerWith({{0x00181500, "DYNAMIC"}}), 3, warnings).angleIncrementsDeg.empty());
    EXPECT_TRUE(io::gantryHeaderOf(headerWith({{0x00181520, "0\\1"}}), 3, warnings).angleIncrementsDeg.empty());
    EXPECT_EQ(warnings.size(), 2U);
    EXPECT_TRUE(io::gantryHeaderOf(headerWith({{0x00181500, "STATIC"}, {0x00181520, "0\\0\\0"}}), 3, warnings)
                    .angleIncrementsDeg.empty());
    EXPECT_EQ(warnings.size(), 2U);
}

TEST(GantryHeader, ReadsWhatTheChecksNeed)
{
    core::Messages warnings;
    const auto header = io::gantryHeaderOf(headerWith({{0x00181114, "1.33"},
                                                       {0x00181147, "RECTANGLE"},
                                                       {0x00181149, "200\\150"},
                                                       {0x00181162, "230"},
                                                       {0x00187026, "310\\420"},
                                                       {0x00280030, "0.3\\0.25"},
                                                       {0x00280034, "6\\5"},
                                                       {0x00280a02, "GEOMETRY"}}),
                                           1, warnings);
    EXPECT_EQ(header.magnification, 1.33);
    EXPECT_EQ(*header.fieldOfViewMm, Eigen::Vector2d(200.0, 150.0));   // width, height, mm
    EXPECT_EQ(*header.detectorMm, Eigen::Vector2d(420.0, 310.0));
    EXPECT_EQ(*header.pixelSpacingMm, Eigen::Vector2d(0.25, 0.3));
    EXPECT_EQ(header.intensifierMm, 230.0);
    EXPECT_TRUE(header.isPixelSpacingCalibrated);
    EXPECT_DOUBLE_EQ(header.pixelAspect, 1.2);
}

/// The standard counts angles from the patient; a device may not. Every difference is reported.
TEST(GantryHeader, AsksAboutAPatientWhoDoesNotLieHeadFirstAndSupine)
{
    core::Messages none;
    io::gantryHeaderOf(headerWith({{0x00185100, "HFS "}}), 1, none);
    EXPECT_TRUE(none.empty());
    for (const char* position : {"FFS ", "HFP ", "FFDL"}) {
        core::Messages warnings;
        const auto header = io::gantryHeaderOf(headerWith({{0x00185100, position}}), 1, warnings);
        ASSERT_TRUE(header.patientPosition);
        EXPECT_TRUE(std::string(position).starts_with(core::toText(*header.patientPosition)));
        ASSERT_EQ(warnings.size(), 1U) << position;
        EXPECT_EQ(warnings.front().id(), "dicom.patient-lies");
        EXPECT_NE(warnings.front().text().find(std::string(position, 3)), std::string::npos);
    }
}

TEST(GantryHeader, SaysThatATableMoved)
{
    core::Messages still;
    io::gantryHeaderOf(headerWith({{0x00181134, "STATIC"}, {0x00181137, "0\\0 "}}), 2, still);
    EXPECT_TRUE(still.empty());
    core::Messages moved;
    io::gantryHeaderOf(headerWith({{0x00181134, "DYNAMIC "}, {0x00181137, "0\\-35 "}}), 2, moved);
    ASSERT_EQ(moved.size(), 1U);
    EXPECT_EQ(moved.front().id(), "dicom.table-moved");
    EXPECT_NE(moved.front().text().find("35 mm"), std::string::npos);
    core::Messages unknown;
    io::gantryHeaderOf(headerWith({{0x00181134, "DYNAMIC "}}), 2, unknown);
    ASSERT_EQ(unknown.size(), 1U);
    EXPECT_EQ(unknown.front().id(), "dicom.table-moved");
}
