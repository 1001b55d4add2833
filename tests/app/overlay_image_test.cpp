#include "app/messages/messages.h"
#include "app/texts/case_texts.h"
#include "app/texts/deformed_vessels.h"
#include "tests/app/sample_picture.h"
#include "tests/support/deformed_case.h"
#include "tests/support/for_each.h"

#include <algorithm>

namespace angiopose::app {
namespace {

class OverlayPicture : public test::SamplePicture {
protected:
    OverlayPicture() : SamplePicture(512) {}
    core::ColorImage drawn(const OverlayImageOptions& wanted) const
    {
        auto picture = drawOverlay(sample, {}, wanted);
        EXPECT_TRUE(picture) << picture.error().message;
        return picture ? std::move(picture).value() : core::ColorImage{};
    }
};

/// Number of pixels that differ in the columns `from` … `to`, below the texts at the top and above those at the bottom.
int differing(const core::ColorImage& a, const core::ColorImage& b, int from, int to)
{
    int count = 0;
    test::forEachPixel({from, a.height / 8}, {to, a.height * 7 / 8}, [&](int x, int y) {
        const auto at =
            3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) + static_cast<std::size_t>(x));
        count += a.rgb[at] != b.rgb[at] || a.rgb[at + 1] != b.rgb[at + 1] || a.rgb[at + 2] != b.rgb[at + 2] ? 1 : 0;
    });
    return count;
}

core::ColorImage columns(const core::ColorImage& whole, int from, int width)
{
    core::ColorImage part{width, whole.height, {}};
    for (int y = 0; y < whole.height; ++y) {
        const std::uint8_t* row = whole.rgb.data() + 3 * (static_cast<std::ptrdiff_t>(y) * whole.width + from);
        part.rgb.insert(part.rgb.end(), row, row + std::ptrdiff_t{3} * width);
    }
    return part;
}

TEST(CornerTexts, SayOfEachDistanceWhereItComesFrom)
{
    core::Case session;
    core::CArm& arm = session.shown().geometry.cArm;
    arm.sourceToDetectorMm = {1050.0, core::Origin::Header, ""};
    arm.sourceToObjectMm = {683.0, core::Origin::Header, ""};
    assumeIsocenter(arm);
    const auto lines = englishTexts(cornerLines(session, Identity::Hidden)).bottomRight;
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_NE(lines.front().find("SID 1050 mm (header)"), std::string::npos) << lines.front();
    EXPECT_NE(lines.front().find("SOD 683 mm (assumed)"), std::string::npos) << lines.front();
    arm.sourceToIsocenterMm = {750.0, core::Origin::Header, ""};
    EXPECT_EQ(englishTexts(cornerLines(session, Identity::Hidden)).bottomRight.front(),
              "SID 1050 · SOD 750 mm (header)");
}

TEST_F(OverlayPicture, ShowsNearAndFarWhereTheWindowDoes)
{
    const core::ColorImage plain = drawn(options);
    options.depthCue = ui::DepthCue::NearBright;
    EXPECT_GT(differing(plain, drawn(options), 0, plain.width), 200);
}

TEST_F(OverlayPicture, LeavesHiddenBranchesOutAsTheWindowDoes)
{
    const core::ColorImage plain = drawn(options);
    for (const core::VesselBranch& branch : sample.vessels.tree->branches) {
        sample.vessels.hiddenBranchIds.push_back(branch.id);
    }
    const core::ColorImage none = drawn(options);
    EXPECT_GT(differing(plain, none, 0, plain.width), 200);
    options.vessels = ui::OverlayMode::Hidden;
    EXPECT_EQ(differing(drawn(options), none, 0, plain.width), 0);
}

TEST_F(OverlayPicture, ShowsDeformedVesselsWhereTheyAreKnownOfThePose)
{
    sample = test::withDeformedVessels(sample, 8.0);
    const core::ColorImage deformed = drawn(options);
    options.shape = VesselShape::Rigid;
    const core::ColorImage rigid = drawn(options);
    EXPECT_GT(differing(rigid, deformed, 0, rigid.width), 200);
    options.coloring = OverlayColoring::Motion;
    EXPECT_GT(differing(rigid, drawn(options), 0, rigid.width), 200);

    options.coloring = OverlayColoring::Branches;
    sample.shown().cameraFromPatient.translation.x() += 1e-9;   // another pose
    const core::ColorImage rigidElsewhere = drawn(options);
    options.shape = VesselShape::Deformed;
    EXPECT_EQ(differing(rigidElsewhere, drawn(options), 0, rigid.width), 0);
}

TEST_F(OverlayPicture, SaysOfWhichFrameTheDeformationIs)
{
    sample = test::withDeformedVessels(sample, 8.0);
    const auto words = [this] {
        const core::View& view = sample.shown();
        return shapeLines(vesselsToDraw(view, sample.vessels, view.cameraFromPatient, VesselShape::Deformed));
    };
    const core::Message other = messages::deformedOnFrame(6);   // counted from 1
    sample.shown().result->provenance.frame = sample.shown().frame;
    EXPECT_FALSE(std::ranges::count(words(), other));
    sample.shown().result->provenance.frame = 5;
    ASSERT_NE(sample.shown().frame, 5);
    EXPECT_EQ(std::ranges::count(words(), other), 1);
}

TEST_F(OverlayPicture, LeavesTheVesselsOutBesideTheSwipe)
{
    const core::ColorImage plain = drawn(options);
    OverlayImageOptions hidden = options;
    hidden.vessels = ui::OverlayMode::Hidden;
    const core::ColorImage bare = drawn(hidden);
    ASSERT_GT(differing(plain, bare, plain.width / 2, plain.width), 100) << "vessels on both sides";
    const double middle = sample.shown().angiogram->width() / 2.0 - 0.5;
    options.cutout = {ui::Cutout::Shape::RightOf, {middle, 0.0}, 0.0};
    const core::ColorImage swiped = drawn(options);
    EXPECT_EQ(differing(swiped, plain, 0, plain.width / 2 - 2), 0);
    EXPECT_EQ(differing(swiped, bare, plain.width / 2 + 2, plain.width), 0);
}

TEST_F(OverlayPicture, PutsTheInitialPoseBesideThePose)
{
    const core::RigidTransform start = core::initialPoseOf(sample).value();
    sample.shown().cameraFromPatient = start;
    sample.shown().cameraFromPatient.translation.x() += 8.0;
    const core::ColorImage after = drawn(options);
    options.isInitialPoseShown = true;
    const core::ColorImage both = drawn(options);
    ASSERT_GT(both.width, 2 * after.width);
    ASSERT_EQ(both.height, after.height);
    sample.shown().cameraFromPatient = start;
    options.isInitialPoseShown = false;
    const core::ColorImage before = drawn(options);
    EXPECT_EQ(differing(columns(both, 0, after.width), before, 0, after.width), 0);
    EXPECT_EQ(differing(columns(both, both.width - after.width, after.width), after, 0, after.width), 0);
    EXPECT_GT(differing(before, after, 0, after.width), 100);
}

/// A bright block whose position encodes the pose, at half the image's resolution.
core::ImageF blockAt(const core::Case& shown, const core::RigidTransform& pose)
{
    core::ImageF picture(shown.shown().angiogram->width() / 2, shown.shown().angiogram->height() / 2);
    const int middle = picture.width / 4 + static_cast<int>(pose.translation.x());
    test::forEachPixel({middle - 6, picture.height / 3}, {middle + 6, picture.height / 2},
                       [&](int x, int y) { picture.at(x, y) = 1.0F; });
    return picture;
}

TEST_F(OverlayPicture, ShowsTheDrrOfEachPoseBeforeAndAfter)
{
    const core::RigidTransform start = core::initialPoseOf(sample).value();
    sample.shown().cameraFromPatient = start;
    sample.shown().cameraFromPatient.translation.x() += 20.0;
    OverlayImageOptions hidden = options;
    hidden.vessels = ui::OverlayMode::Hidden;
    const core::ColorImage bare = drawn(hidden);
    options.drr = [this](const core::RigidTransform& pose) -> core::Result<core::ImageF> {
        return blockAt(sample, pose);
    };
    const core::ColorImage after = drawn(options);
    options.isInitialPoseShown = true;
    const core::ColorImage both = drawn(options);
    const core::ColorImage left = columns(both, 0, bare.width),
                           right = columns(both, both.width - bare.width, bare.width);
    EXPECT_EQ(differing(right, after, 0, bare.width), 0);
    EXPECT_GT(differing(left, bare, 0, bare.width), 1000) << "a block, not centrelines";
    EXPECT_GT(differing(left, right, 0, bare.width), 1000) << "at another pose";
}

TEST_F(OverlayPicture, LeavesTheDrrOutBesideTheSwipe)
{
    OverlayImageOptions hidden = options;
    hidden.vessels = ui::OverlayMode::Hidden;
    const core::ColorImage bare = drawn(hidden);
    options.drr = [this](const core::RigidTransform&) -> core::Result<core::ImageF> {
        return core::ImageF(sample.shown().angiogram->width(), sample.shown().angiogram->height(), 1.0F);
    };
    options.cutout = {ui::Cutout::Shape::RightOf, {sample.shown().angiogram->width() / 2.0 - 0.5, 0.0}, 0.0};
    const core::ColorImage swiped = drawn(options);
    EXPECT_EQ(differing(swiped, bare, bare.width / 2 + 2, bare.width), 0);
    EXPECT_EQ(differing(swiped, bare, 0, bare.width / 2 - 2),
              (bare.width / 2 - 2) * (bare.height * 7 / 8 - bare.height / 8));
}

TEST_F(OverlayPicture, NeedsAStartPoseForBeforeAndAfter)
{
    sample.shown().initialCameraFromPatient.reset();
    sample.shown().geometry.cArm.primaryAngleDeg = {};
    options.isInitialPoseShown = true;
    EXPECT_FALSE(drawOverlay(sample, {}, options));
}

}   // namespace
}   // namespace angiopose::app
