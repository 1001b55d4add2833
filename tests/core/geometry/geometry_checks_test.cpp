#include "core/geometry/geometry_checks.h"
#include "core/messages/messages.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

CArm usual()
{
    CArm cArm;
    cArm.sourceToDetectorMm = {1050.0, Origin::Header, ""};
    cArm.sourceToIsocenterMm = {750.0, Origin::Header, ""};
    cArm.columnSpacingMm = {0.4, Origin::Header, ""};
    cArm.rowSpacingMm = {0.4, Origin::Header, ""};
    cArm.primaryAngleDeg = {-30.0, Origin::Header, ""};
    cArm.secondaryAngleDeg = {20.0, Origin::Header, ""};
    return cArm;
}

GantryHeader agreeing()
{
    GantryHeader header;
    header.magnification = 1.4;
    header.fieldOfViewMm = {204.8, 204.8};
    header.intensifierMm = 220.0;
    header.detectorMm = {300.0, 300.0};
    header.pixelSpacingMm = {0.4 / 1.4, 0.4 / 1.4};
    header.isPixelSpacingCalibrated = true;
    return header;
}

const Eigen::Vector2i size(512, 512);

/// The only message that a single wrong value causes.
std::string onlySentence(const CArm& cArm, const GantryHeader& header)
{
    const auto found = findContradictions(cArm, header, size);
    EXPECT_EQ(found.size(), 1U) << (found.empty() ? "nothing found" : found.back().text());
    return found.empty() ? "" : found.front().text();
}

/// A wrong value, and a word of the message about it.
struct Wrong {
    const char* word;
    void (*spoil)(CArm&, GantryHeader&);
};

const Wrong wrongs[] = {
    {"behind the detector",
     [](CArm& c, GantryHeader& h) {
         c.sourceToIsocenterMm.value = 1200.0;
         h = {};
     }},
    {"typical angiographic magnification",
     [](CArm& c, GantryHeader& h) {
         c.sourceToIsocenterMm.value = 400.0;
         h = {};
     }},
    {"check the unit",
     [](CArm& c, GantryHeader& h) {
         c.sourceToDetectorMm.value = 105.0;
         c.sourceToIsocenterMm.value = 75.0;
         h = {};
     }},
    {"(0018,1114)", [](CArm&, GantryHeader& h) { h.magnification = 1.5; }},
    {"ratio of pixel height to width",
     [](CArm& c, GantryHeader& h) {
         c.rowSpacingMm.value = 0.42;
         h = {};
     }},
    {"field of view",
     [](CArm&, GantryHeader& h) {
         h.fieldOfViewMm = {150.0, 150.0};
     }},
    {"intensifier", [](CArm&, GantryHeader& h) { h.intensifierMm = 160.0; }},
    {"active",
     [](CArm&, GantryHeader& h) {
         h.detectorMm = {180.0, 300.0};
     }},
    {"calibrat",
     [](CArm&, GantryHeader& h) {
         h.pixelSpacingMm = {0.4, 0.4};
     }},
    {"uncalibrated Pixel Spacing", [](CArm&, GantryHeader& h) { h.isPixelSpacingCalibrated = false; }},
    {"primary angle", [](CArm& c, GantryHeader&) { c.primaryAngleDeg.value = 200.0; }},
    {"secondary angle", [](CArm& c, GantryHeader&) { c.secondaryAngleDeg.value = -95.0; }},
    {"roll", [](CArm& c, GantryHeader&) { c.rollDeg.value = 270.0; }},
    {"principal point",
     [](CArm& c, GantryHeader&) {
         c.principalPointPx.value = {900.0, 10.0};
     }},
    {"no C-arm detector",
     [](CArm& c, GantryHeader& h) {
         c.columnSpacingMm.value = c.rowSpacingMm.value = 1.9;
         h = {};
     }},
};

}   // namespace

TEST(GeometryChecks, PassWhatAgrees)
{
    EXPECT_TRUE(findContradictions(usual(), agreeing(), size).empty());
    EXPECT_TRUE(findContradictions(usual()).empty());
    EXPECT_TRUE(findContradictions({}, agreeing(), size).empty());
    EXPECT_TRUE(findMissingGeometry(usual()).empty());
}

TEST(GeometryChecks, NameWhatEachWrongValueContradicts)
{
    for (const Wrong& wrong : wrongs) {
        CArm cArm = usual();
        GantryHeader header = agreeing();
        wrong.spoil(cArm, header);
        EXPECT_NE(onlySentence(cArm, header).find(wrong.word), std::string::npos)
            << wrong.word << ": " << onlySentence(cArm, header);
    }
}

TEST(GeometryChecks, ATypedDistanceNeedNotMatchTheHeadersMagnification)
{
    CArm cArm = usual();
    cArm.sourceToIsocenterMm = {700.0, Origin::User, ""};
    GantryHeader header;
    header.magnification = 1.4;
    EXPECT_TRUE(findContradictions(cArm, header, size).empty());
}

TEST(GeometryChecks, PixelsThatAreMeantToBeOblongAreFine)
{
    CArm cArm = usual();
    cArm.rowSpacingMm.value = 0.48;
    GantryHeader header;
    header.pixelAspect = 1.2;
    EXPECT_TRUE(findContradictions(cArm, header, size).empty());
}

TEST(GeometryChecks, AskForEverythingThatIsMissing)
{
    EXPECT_EQ(findMissingGeometry({}).size(), 5U);
    CArm cArm = usual();
    cArm.rowSpacingMm = {};
    ASSERT_EQ(findMissingGeometry(cArm).size(), 1U);
    EXPECT_TRUE(findMissingGeometry(cArm).front().is(messages::askSpacing));
}

}   // namespace angiopose::core
