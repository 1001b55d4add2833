#include "io/dicom/c_arm_tags.h"

#include "io/dicom/gantry_tags.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <cstdint>

using namespace angiopose;

namespace {

struct HeaderElement {
    io::DicomTag tag;
    const char* vr;   ///< with a length of two bytes; "UN": of four bytes
    std::string value;
};

/// A data set with these elements in ascending order, with VRs only if `isExplicit`.
io::DicomDataset dicomWith(const std::vector<HeaderElement>& elements, bool isExplicit = true)
{
    std::string bytes;
    const auto add = [&](std::size_t number, int count) {
        for (int k = 0; k < count; ++k) {
            bytes += static_cast<char>(number >> (8 * k) & 0xff);
        }
    };
    for (const auto& [tag, vr, text] : elements) {
        const std::string value = text.size() % 2 == 1 ? text + " " : text;
        add(tag >> 16, 2);
        add(tag & 0xffff, 2);
        if (!isExplicit) {
            add(value.size(), 4);
        } else {
            bytes += vr;
            const bool isLong = std::string_view(vr) == "UN";
            add(isLong ? 0 : value.size(), 2);
            if (isLong) {
                add(value.size(), 4);
            }
        }
        bytes += value;
    }
    return io::readElements(bytes, io::DicomEncoding{isExplicit});
}

std::string asLongs(std::initializer_list<std::int32_t> values)
{
    std::string bytes;
    for (const std::int32_t value : values) {
        for (int k = 0; k < 4; ++k) {
            bytes += static_cast<char>(static_cast<std::uint32_t>(value) >> (8 * k) & 0xffU);
        }
    }
    return bytes;
}

const std::string siemensRoom = "SIEMENS SMS-AX  ACQ 1.0";

core::CArm armOf(const std::vector<HeaderElement>& elements, core::Messages* warnings = nullptr)
{
    core::Messages said;
    return io::cArmOf(dicomWith(elements), warnings ? *warnings : said);
}

bool isSaidOf(const core::Messages& warnings, std::string_view id)
{
    return std::ranges::any_of(warnings, [&](const core::Message& each) { return each.id() == id; });
}

/// Patient Orientation letters of a direction in the patient, from the formulas of PS3.3 only.
std::string lettersAlong(const Eigen::Vector3d& direction)
{
    std::vector<std::pair<double, char>> parts;
    for (int axis = 0; axis < 3; ++axis) {
        parts.emplace_back(-std::abs(direction[axis]), direction[axis] > 0.0 ? "LPH"[axis] : "RAF"[axis]);
    }
    std::ranges::sort(parts);
    std::string letters;
    for (const auto& [weight, letter] : parts) {
        letters += weight < -0.2 ? std::string(1, letter) : "";
    }
    return letters;
}

}   // namespace

TEST(CArmTags, TheIsocenterIsNotTheObjectPlane)
{
    core::Messages warnings;
    const core::CArm arm = armOf({{0x00181110, "DS", "1100"},
                                  {0x00181111, "DS", "683"},
                                  {0x00210010, "LO", siemensRoom},
                                  {0x00211017, "SL", asLongs({750})}},
                                 &warnings);
    EXPECT_EQ(arm.sourceToIsocenterMm.value, 750.0);
    EXPECT_EQ(arm.sourceToIsocenterMm.origin, core::Origin::Header);
    EXPECT_NE(arm.sourceToIsocenterMm.basis.find("(0021,1017)"), std::string::npos);
    EXPECT_EQ(arm.sourceToObjectMm.value, 683.0);
    ASSERT_TRUE(isSaidOf(warnings, "dicom.object-off-isocenter"));
    const core::CArm standard = armOf({{0x00181110, "DS", "1100"},
                                       {0x00181111, "DS", "683"},
                                       {0x00189402, "FL", std::string("\x00\x80\x44\x44", 4)},
                                       {0x00210010, "LO", siemensRoom},
                                       {0x00211017, "SL", asLongs({750})}});
    EXPECT_EQ(standard.sourceToIsocenterMm.value, 786.0) << "the standard's own tag comes first";
}

TEST(CArmTags, FindThePrivateBlockByItsCreatorWhereverItLies)
{
    const std::vector<std::vector<HeaderElement>> sameRoom{
        {{0x00210010, "LO", "SIEMENS SMS-AX ACQ 1.0"}, {0x00211017, "SL", asLongs({750})}},
        {{0x00210010, "LO", "SOMEBODY"},
         {0x00210042, "LO", siemensRoom},
         {0x00211017, "SL", asLongs({600})},
         {0x00214217, "IS", "750"}},
        {{0x00210010, "LO", siemensRoom}, {0x00211017, "UN", asLongs({750})}},
        {{0x00210010, "LO", siemensRoom}, {0x00211017, "US", std::string("\xee\x02", 2)}}};
    for (const auto& elements : sameRoom) {
        EXPECT_EQ(armOf(elements).sourceToIsocenterMm.value, 750.0);
    }
    EXPECT_FALSE(armOf({{0x00210010, "LO", "SOMEBODY"}, {0x00211017, "SL", asLongs({750})}}).sourceToIsocenterMm.value);
    core::Messages none;
    EXPECT_EQ(io::cArmOf(dicomWith({{0x00210010, "LO", siemensRoom}, {0x00211017, "SL", asLongs({750})}}, false), none)
                  .sourceToIsocenterMm.value,
              750.0)
        << "without VRs";
}

TEST(CArmTags, WhatNoIsocenterCanBeIsNone)
{
    for (const int distance : {0, 75, 499, 1001, 7500, 1000}) {
        const core::CArm arm = armOf({{0x00181110, "DS", "990"},
                                      {0x00181111, "DS", "700"},
                                      {0x00210010, "LO", siemensRoom},
                                      {0x00211017, "SL", asLongs({distance})}});
        EXPECT_EQ(arm.sourceToIsocenterMm.value, 700.0) << distance;
        EXPECT_EQ(arm.sourceToIsocenterMm.origin, core::Origin::Assumed) << distance;
        EXPECT_EQ(arm.sourceToObjectMm.origin, core::Origin::Header) << distance;
    }
}

/// All eight orientations in which an image can be stored, at angles all around the patient.
TEST(CArmTags, PatientOrientationTellsMirrorAndTurnAtEveryAngle)
{
    for (int primary = -180; primary <= 180; primary += 15) {
        for (const int secondary : {-40, -20, 0, 20, 40}) {
            const double a = primary * 3.14159265358979323846 / 180.0, b = secondary * 3.14159265358979323846 / 180.0;
            const Eigen::Vector3d right(std::cos(a), std::sin(a), 0.0);
            const Eigen::Vector3d down(std::sin(b) * std::sin(a), -std::sin(b) * std::cos(a), -std::cos(b));
            for (const bool isMirrored : {false, true}) {
                for (const int turn : {0, 90, 180, -90}) {
                    // Optionally mirrored, then rotated clockwise: a direction that pointed up points right.
                    const Eigen::Vector3d seen = isMirrored ? Eigen::Vector3d(-right) : right;
                    const double c = std::round(std::cos(turn * 3.14159265358979323846 / 180.0));
                    const double s = std::round(std::sin(turn * 3.14159265358979323846 / 180.0));
                    const Eigen::Vector3d row = c * seen - s * down, column = s * seen + c * down;
                    core::Messages warnings;
                    const core::CArm arm = armOf({{0x00181510, "DS", std::to_string(primary)},
                                                  {0x00181511, "DS", std::to_string(secondary)},
                                                  {0x00200020, "CS", lettersAlong(row) + "\\" + lettersAlong(column)}},
                                                 &warnings);
                    const std::string what = std::to_string(primary) + " " + std::to_string(secondary) + " " +
                                             std::to_string(isMirrored) + " " + std::to_string(turn) + " " +
                                             lettersAlong(row) + "\\" + lettersAlong(column);
                    EXPECT_EQ(arm.mirrored.value, isMirrored) << what;
                    EXPECT_EQ(arm.rollDeg.value.value_or(0.0), turn) << what;
                    EXPECT_EQ(isSaidOf(warnings, "dicom.image-mirrored"), isMirrored) << what;
                    EXPECT_EQ(isSaidOf(warnings, "dicom.image-turned"), turn != 0) << what;
                }
            }
        }
    }
}

TEST(CArmTags, OrientationThatNoImageHasIsSaid)
{
    core::Messages warnings;
    const core::CArm arm =
        armOf({{0x00181510, "DS", "90"}, {0x00181511, "DS", "0"}, {0x00200020, "CS", "L\\F"}}, &warnings);
    EXPECT_FALSE(arm.mirrored.value);
    EXPECT_TRUE(isSaidOf(warnings, "dicom.orientation-unlike-angles"));
    core::Messages none;
    EXPECT_EQ(armOf({{0x00181510, "DS", "90"}, {0x00200020, "CS", "A"}}, &none).mirrored.value, true) << "a row alone";
}

TEST(GantryHeaderTable, IsTheIsocenterInThePatient)
{
    const auto tableOf = [](const char* position, const std::vector<HeaderElement>& more) {
        std::vector<HeaderElement> elements{{0x00185100, "CS", position}};
        elements.insert(elements.end(), more.begin(), more.end());
        core::Messages warnings;
        return io::gantryHeaderOf(dicomWith(elements), 1, warnings).table;
    };
    // longitudinal, lateral, vertical
    const std::vector<HeaderElement> siemens{{0x00210010, "LO", siemensRoom},
                                             {0x00211057, "SL", asLongs({1230, -450, 78})}};
    ASSERT_TRUE(tableOf("HFS", siemens));
    EXPECT_LT((tableOf("HFS", siemens)->isocenterInPatientMm - Eigen::Vector3d(-45.0, -7.8, -123.0)).norm(), 1e-9);
    EXPECT_LT((tableOf("FFS", siemens)->isocenterInPatientMm - Eigen::Vector3d(45.0, -7.8, 123.0)).norm(), 1e-9);
    EXPECT_LT((tableOf("HFP", siemens)->isocenterInPatientMm - Eigen::Vector3d(45.0, 7.8, -123.0)).norm(), 1e-9);
    EXPECT_FALSE(tableOf("SITTING", siemens));
    const std::vector<HeaderElement> text{{0x00210010, "LO", siemensRoom}, {0x00211057, "UN", "1230\\-450\\78"}};
    ASSERT_TRUE(tableOf("HFS", text));
    EXPECT_EQ(tableOf("HFS", text)->isocenterInPatientMm, tableOf("HFS", siemens)->isocenterInPatientMm);
    // left, down, head; the isocenter has the opposite sign
    std::vector<HeaderElement> standard{
        {0x00189466, "DS", "10"}, {0x00189467, "DS", "-20"}, {0x00189468, "DS", "30.5"}};
    ASSERT_TRUE(tableOf("HFS", standard));
    EXPECT_EQ(tableOf("HFS", standard)->isocenterInPatientMm, Eigen::Vector3d(-10.0, 20.0, -30.5));
    EXPECT_EQ(tableOf("HFS", standard)->tags, core::TablePosition::Tags::Standard);
    standard.push_back({0x00189469, "DS", "12"});
    EXPECT_FALSE(tableOf("HFS", standard)) << "a table that is turned";
}

TEST(GantryHeaderTable, MovesWhereAnyTagSaysSo)
{
    core::Messages warnings;
    const auto header = io::gantryHeaderOf(
        dicomWith({{0x00210010, "LO", siemensRoom}, {0x00211024, "US", std::string("\x01\x00", 2)}}), 2, warnings);
    EXPECT_TRUE(header.tableMoves);
    EXPECT_TRUE(isSaidOf(warnings, "dicom.table-moved"));
    EXPECT_TRUE(io::gantryHeaderOf(dicomWith({{0x00181134, "CS", "DYNAMIC"}}), 2, warnings).tableMoves);
    core::Messages still;
    EXPECT_FALSE(
        io::gantryHeaderOf(dicomWith({{0x00210010, "LO", siemensRoom}, {0x00211024, "US", std::string("\x00\x00", 2)}}),
                           2, still)
            .tableMoves);
    EXPECT_TRUE(still.empty());
}

TEST(GantryHeaderBiplane, IsOneMomentOfAPlane)
{
    core::Messages warnings;
    const auto header = io::gantryHeaderOf(dicomWith({{0x00080008, "CS", "ORIGINAL\\PRIMARY\\BIPLANE B"},
                                                      {0x00080022, "DA", "20240229"},
                                                      {0x00080032, "TM", "101500.5"}}),
                                           2, warnings);
    ASSERT_TRUE(header.biplane);
    EXPECT_EQ(header.biplane->plane, 'B');
    EXPECT_EQ(header.biplane->timeS, 36900.5);
    EXPECT_FALSE(io::gantryHeaderOf(dicomWith({{0x00080008, "CS", "ORIGINAL\\PRIMARY\\SINGLE PLANE"},
                                               {0x00080022, "DA", "20240229"},
                                               {0x00080032, "TM", "101500.5"}}),
                                    2, warnings)
                     .biplane);
}
