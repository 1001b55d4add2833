#include "core/measuring/branch_profile.h"

#include "core/messages/messages.h"
#include "core/tracing/volume/trace_vessels.h"
#include "tests/support/drawn_tubes.h"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>
#include <numbers>

namespace angiopose::core {
namespace {

/// A branch of 60 mm along x, with one point per millimeter.
VesselBranch straight(const std::function<double(double)>& diameterAt)
{
    VesselBranch branch{3, "", {}, {}, 0};
    for (int i = 0; i <= 60; ++i) {
        branch.pointsInPatient.emplace_back(i, 2.0, -7.0);
        branch.radiusMm.push_back(0.5 * diameterAt(i));
    }
    return branch;
}

VesselBranch arc(double radiusMm, double turnDeg)
{
    VesselBranch branch{4, "", {}, {}, 0};
    for (int i = 0; i <= 100; ++i) {
        const double angle = turnDeg / 180.0 * std::numbers::pi * i / 100.0;
        branch.pointsInPatient.emplace_back(radiusMm * std::cos(angle), 5.0, radiusMm * std::sin(angle));
    }
    return branch;
}

}   // namespace

TEST(BranchProfile, ASmoothTaperIsItsOwnReference)
{
    const auto profile = measureProfile(straight([](double arc) { return 4.0 - arc / 40.0; }));
    ASSERT_TRUE(profile);
    EXPECT_NEAR(profile.value().lengthMm, 60.0, 1e-9);
    EXPECT_NEAR(profile.value().tortuosity, 1.0, 1e-12);
    EXPECT_NEAR(profile.value().maxCurvaturePerMm, 0.0, 1e-9);
    EXPECT_NEAR(*profile.value().meanDiameterMm, 3.25, 0.02);
    ASSERT_TRUE(profile.value().stenosis);
    EXPECT_LT(profile.value().stenosis->percent, 1.0);
    EXPECT_NEAR(profile.value().samples[60].referenceDiameterMm, 3.25, 0.02);
    EXPECT_TRUE(std::isnan(profile.value().samples.front().referenceDiameterMm)) << "the ends do not count";
}

TEST(BranchProfile, FindsAStenosisOfATaperingVessel)
{
    for (const double depth : {0.3, 0.5, 0.8}) {
        const auto lesion = [depth](double arc) {   // 12 mm long, most severe at 35 mm
            return std::abs(arc - 35.0) < 6.0 ? depth * 0.5 * (1.0 + std::cos((arc - 35.0) * std::numbers::pi / 6.0))
                                              : 0.0;
        };
        const auto profile =
            measureProfile(straight([&](double arc) { return (4.0 - arc / 40.0) * (1.0 - lesion(arc)); }));
        ASSERT_TRUE(profile && profile.value().stenosis) << depth;
        const StenosisMeasure& found = *profile.value().stenosis;
        EXPECT_NEAR(found.percent, 100.0 * depth, 4.0);
        EXPECT_NEAR(found.positionMm, 35.0, 0.6);
        EXPECT_NEAR(found.referenceDiameterMm, 4.0 - 35.0 / 40.0, 0.08);
        EXPECT_GT(found.fromMm, 29.0);
        EXPECT_LT(found.fromMm, 33.0);
        EXPECT_GT(found.toMm, 37.0);
        EXPECT_LT(found.toMm, 41.0);
    }
}

TEST(BranchProfile, ALongLesionAndAnAneurysmAreNoReference)
{
    const auto profile = measureProfile(straight([](double arc) { return arc > 20 && arc < 46 ? 1.8 : 3.0; }));
    ASSERT_TRUE(profile && profile.value().stenosis);
    EXPECT_NEAR(profile.value().stenosis->percent, 40.0, 3.0);
    const auto wide = measureProfile(straight([](double arc) { return arc > 20 && arc < 32 ? 6.0 : 3.0; }));
    ASSERT_TRUE(wide && wide.value().stenosis);
    EXPECT_LT(wide.value().stenosis->percent, 3.0) << "nothing is narrower than a healthy vessel there";
    EXPECT_NEAR(*wide.value().maxDiameterMm, 6.0, 1e-9);
}

/// Each bifurcation reduces the diameter: from 6 to 2 mm over 160 mm, in steps.
TEST(BranchProfile, AVesselThatGivesOffBranchesHasNoStenosisAtItsEnd)
{
    VesselBranch branch{3, "", {}, {}, 0};
    for (int i = 0; i <= 160; ++i) {
        branch.pointsInPatient.emplace_back(i, 0.0, 0.0);
        branch.radiusMm.push_back(3.0 * std::pow(0.83, std::floor(i / 27.0)));
    }
    const auto profile = measureProfile(branch);
    ASSERT_TRUE(profile && profile.value().stenosis);
    EXPECT_LT(profile.value().stenosis->percent, 12.0) << "at " << profile.value().stenosis->positionMm;

    for (std::size_t i = 0; i < branch.radiusMm.size(); ++i) {
        branch.radiusMm[i] = i < 130 ? 1.6 : 0.9;
    }
    EXPECT_LT(measureProfile(branch).value().stenosis->percent, 5.0) << "it stays as narrow as it becomes";
}

TEST(BranchProfile, EndsInTheParentOrAtTheTipAreNoStenosis)
{
    const auto profile = measureProfile(straight([](double arc) { return arc < 2.0 ? 6.0 : arc > 58.5 ? 1.0 : 3.0; }));
    ASSERT_TRUE(profile && profile.value().stenosis);
    EXPECT_LT(profile.value().stenosis->percent, 3.0);
    EXPECT_NEAR(profile.value().stenosis->referenceDiameterMm, 3.0, 0.1);
}

TEST(BranchProfile, CurvatureAndTortuosityOfArcs)
{
    for (const double radiusMm : {8.0, 15.0, 40.0}) {
        const auto profile = measureProfile(arc(radiusMm, 180.0));
        ASSERT_TRUE(profile);
        EXPECT_NEAR(profile.value().tortuosity, 0.5 * std::numbers::pi, 0.001) << radiusMm;
        EXPECT_NEAR(profile.value().maxCurvaturePerMm * radiusMm, 1.0, 0.08) << radiusMm;
        const ProfileSample& middle = profile.value().samples[profile.value().samples.size() / 2];
        EXPECT_NEAR(middle.curvaturePerMm * radiusMm, 1.0, 0.08) << radiusMm;
    }
}

TEST(BranchProfile, WithoutRadiiItSaysSoAndMeasuresTheRest)
{
    VesselBranch branch = straight([](double) { return 3.0; });
    branch.radiusMm.clear();
    const auto profile = measureProfile(branch);
    ASSERT_TRUE(profile);
    EXPECT_NEAR(profile.value().lengthMm, 60.0, 1e-9);
    EXPECT_FALSE(profile.value().meanDiameterMm);
    EXPECT_FALSE(profile.value().stenosis);
    EXPECT_TRUE(std::isnan(profile.value().samples[10].diameterMm));
    ASSERT_EQ(profile.value().warnings.size(), 1U);
    EXPECT_TRUE(profile.value().warnings[0].is(messages::profileNoRadii));

    branch = straight([](double) { return 3.0; });
    branch.radiusMm[20] = std::nan("");
    EXPECT_FALSE(measureProfile(branch).value().meanDiameterMm);
    branch.radiusMm[20] = -1.0;
    EXPECT_FALSE(measureProfile(branch).value().meanDiameterMm);
}

TEST(BranchProfile, BranchesWithoutLengthAreRefused)
{
    EXPECT_FALSE(measureProfile({1, "", {}, {}, 0}));
    EXPECT_FALSE(measureProfile({1, "", {{1, 2, 3}}, {}, 0}));
    EXPECT_FALSE(measureProfile({1, "", {{1, 2, 3}, {1, 2, 3}}, {}, 0}));
    EXPECT_FALSE(measureProfile({1, "", {{1, 2, 3}, {1, std::nan(""), 3}}, {}, 0}));
    const auto tiny = measureProfile({1, "", {{0, 0, 0}, {0.3, 0, 0}}, {1.0, 1.0}, 0});
    ASSERT_TRUE(tiny);
    EXPECT_TRUE(std::isnan(tiny.value().maxCurvaturePerMm));
    EXPECT_FALSE(tiny.value().stenosis) << "nothing to compare with";
}

/// Diameter errors of the samples of a tube, away from its trunk and tip. The tube leaves a trunk, oblique to the grid,
/// and is traced in a simulated scan.
std::vector<double> errorsOfTracedTubeMm(double diameterMm, double voxelMm)
{
    const test::Tube trunk{{-28, 0, -30}, {-28, 0, 30}, 10.0};
    const test::Tube tube{{-28, 0, -2}, {28, 6, 11}, 0.5 * diameterMm};
    const Eigen::Vector3i size = (Eigen::Vector3d(84, 40, 68) / voxelMm).cast<int>();
    const auto traced = traceVessels(
        test::tubesInTissue(test::gridAround({0, 0, 0}, size, Eigen::Vector3d::Constant(voxelMm)), {trunk, tube}));
    EXPECT_TRUE(traced) << diameterMm << ": " << traced.error().message;
    std::vector<double> errorsMm;
    if (!traced) {
        return errorsMm;
    }
    const double clearMm = std::max(diameterMm, 3.0);
    for (const VesselBranch& branch : traced.value().tree.branches) {
        const auto profile = measureProfile(branch);
        for (const ProfileSample& sample : profile ? profile.value().samples : std::vector<ProfileSample>{}) {
            const double x = sample.pointInPatient.x();
            if (x > -18.0 + clearMm && x < 28.0 - clearMm) {
                errorsMm.push_back(sample.diameterMm - diameterMm);
            }
        }
    }
    return errorsMm;
}

TEST(BranchProfile, DiametersOfTracedTubes)
{
    for (const double diameterMm : {2.0, 3.0, 4.0, 6.0, 8.0, 10.0, 12.0}) {
        const std::vector<double> errorsMm = errorsOfTracedTubeMm(diameterMm, diameterMm < 5.0 ? 0.5 : 0.7);
        EXPECT_GT(errorsMm.size(), 30U) << diameterMm;
        const double allowedMm = std::max(0.05 * diameterMm, 0.3);
        double worstMm = 0.0;
        for (const double errorMm : errorsMm) {
            worstMm = std::abs(errorMm) > std::abs(worstMm) ? errorMm : worstMm;
        }
        EXPECT_LT(std::abs(worstMm), allowedMm) << diameterMm;
        RecordProperty("worst_um_at_" + std::to_string(std::lround(diameterMm)) + "_mm",
                       static_cast<int>(std::lround(1000.0 * worstMm)));
    }
}

}   // namespace angiopose::core
