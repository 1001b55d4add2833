#include "core/messages/messages.h"
#include "core/registration/deformable/deformed_tree.h"
#include "io/messages/messages.h"
#include "io/motion_table.h"
#include "io/results/result_file.h"
#include "tests/io/case/small_case.h"

#include <cmath>

using namespace angiopose;

namespace {

/// A deformation result in which every point of a tree moved by a different displacement.
core::DeformableResult richDeformation(const core::Case& session)
{
    core::DeformableResult deformed;
    deformed.verdict = core::DeformationVerdict::Unsure;
    deformed.cameraFromPatient = session.shown().cameraFromPatient;
    deformed.viewPoses = {deformed.cameraFromPatient, core::RigidTransform{}};
    double number = 1.0;
    for (const core::VesselBranch& branch : session.vessels.tree->branches) {
        core::BranchMotion& motion = deformed.branches.emplace_back();
        motion.branchId = branch.id;
        motion.seenShare = 1.0 / 3.0;
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            number *= -1.07;
            motion.displacementMm.emplace_back(number / 3.0, 0.1 * number, number);
            Eigen::Matrix3d covariance = Eigen::Vector3d(0.1 / 3.0, 0.02, 4.0).asDiagonal();
            covariance(0, 2) = covariance(2, 0) = 0.01 * number;
            motion.covariance.push_back(covariance);
        }
        core::roundMotion(motion);
    }
    deformed.logEvidenceGain = 100.0 / 3.0;
    deformed.largestMotionMm = 3.25;
    deformed.rigid.meanMm = 0.7;
    deformed.rigid.farthestBranchId = session.vessels.tree->branches.front().id;
    deformed.stopReason = core::StopReason::IterationLimit;
    deformed.iterations = 14;
    deformed.timeMs = 99.5;
    deformed.messages = {core::messages::deformationDepthUnknown()};
    return deformed;
}

/// A result with every field set, as after a registration; the pose is that of `session`.
core::RegistrationResult richResult(const core::Case& session)
{
    core::RegistrationResult result;
    result.method = "dynaweight";
    result.cameraFromPatient = session.shown().cameraFromPatient;
    result.stopReason = core::StopReason::StoppedByUser;
    result.iterations = 12;
    result.metrics.medianPx = 1.0 / 3.0;
    result.metrics.coverage = std::nan("");   // nothing to cover
    result.uncertainty.covariance.setConstant(0.1 + 0.2);
    result.uncertainty.rotationDeg = {0.1, 0.2, 1.0 / 7.0};
    result.uncertainty.depthMm = 12.5;
    result.uncertainty.observed = {true, false, true, true, true, false};
    result.uncertainty.weakestDirection[5] = 1.0;
    result.branches = {{1, 21, 0.5, 2.5, 0.75}, {2, 9, 1.5, 3.5, 0.25}};
    result.unopacified = {{4, 0.75}};
    result.alternatives = {{session.shown().cameraFromPatient, 0.9}};
    result.wirePaths = {{{1, 3, 7}, {1.0 / 3.0, -2.5, 4.0}, 0.8, 1.25, 0.95, session.shown().cameraFromPatient, {}},
                        {{1, 4}, {0.0, 1.0, 2.0}, 0.15, 1.5, 0.9, session.shown().cameraFromPatient, {}}};
    result.trustworthy = false;
    result.probabilityWithin2Mm = 0.1 + 0.2;
    result.warnings = {core::messages::poseUncertain(core::inMm(2.44, 1)), core::messages::registrationStopped(),
                       core::messages::inView(2, io::messages::fileMissing().about("b.dcm")).as(core::Severity::Note)};
    result.time = {1.0, 2.0, 3.0, 6.5};
    result.provenance = {"Ada", "2026-05-04T12:30:00Z", "0.1.0", session.options};
    result.provenance.options.maxIterations = 33;
    result.provenance.frame = 0;
    core::IterationReport report;
    report.iteration = 3;
    report.stage = "refine";
    report.progress = 0.25;
    report.scalePx = 7.5;
    report.medianDistancePx = 4.0 / 3.0;
    report.stepMm = 0.5;
    report.cameraFromPatient = session.shown().cameraFromPatient;
    report.view = 1;
    result.history = {report, report};
    return result;
}

class CaseResult : public ::testing::Test {
protected:
    CaseResult()
    {
        auto loaded = small.load(small.json());
        EXPECT_TRUE(loaded);
        session = std::move(loaded).value();
        session.shown().result = richResult(session);
        EXPECT_TRUE(io::saveCase(session, small.path("saved.angiopose")));
    }

    core::Case reopened()
    {
        small.warnings.clear();
        auto loaded = io::loadCase(small.path("saved.angiopose"), small.warnings);
        EXPECT_TRUE(loaded) << loaded.error().message;
        return std::move(loaded).value();
    }

    nlohmann::json saved() const { return nlohmann::json::parse(test::readText(small.path("saved.angiopose"))); }

    test::SmallCase small;
    core::Case session;
};

TEST_F(CaseResult, IsRestoredToTheLastBit)
{
    const core::Case copy = reopened();
    ASSERT_TRUE(copy.shown().result);
    const core::RegistrationResult& was = *session.shown().result;
    const core::RegistrationResult& is = *copy.shown().result;
    EXPECT_EQ(is.method, was.method);
    EXPECT_EQ(is.cameraFromPatient.matrix(), was.cameraFromPatient.matrix());
    EXPECT_EQ(is.stopReason, was.stopReason);
    EXPECT_EQ(is.iterations, was.iterations);
    EXPECT_EQ(is.metrics.medianPx, was.metrics.medianPx);
    EXPECT_TRUE(std::isnan(is.metrics.coverage));
    EXPECT_EQ(is.uncertainty.covariance, was.uncertainty.covariance);
    EXPECT_EQ(is.uncertainty.rotationDeg, was.uncertainty.rotationDeg);
    EXPECT_EQ(is.uncertainty.observed, was.uncertainty.observed);
    EXPECT_EQ(is.uncertainty.weakestDirection, was.uncertainty.weakestDirection);
    ASSERT_EQ(is.branches.size(), 2U);
    EXPECT_EQ(is.branches[1].agreement, was.branches[1].agreement);
    ASSERT_EQ(is.unopacified.size(), 1U);
    EXPECT_EQ(is.unopacified[0].branchId, 4);
    EXPECT_EQ(is.unopacified[0].share, 0.75);
    ASSERT_EQ(is.alternatives.size(), 1U);
    EXPECT_EQ(is.alternatives[0].score, 0.9);
    ASSERT_EQ(is.wirePaths.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(is.wirePaths[i].branchIds, was.wirePaths[i].branchIds);
        EXPECT_EQ(is.wirePaths[i].tipInPatient, was.wirePaths[i].tipInPatient);
        EXPECT_EQ(is.wirePaths[i].probability, was.wirePaths[i].probability);
        EXPECT_EQ(is.wirePaths[i].offAxisMm, was.wirePaths[i].offAxisMm);
        EXPECT_EQ(is.wirePaths[i].followedShare, was.wirePaths[i].followedShare);
        EXPECT_EQ(is.wirePaths[i].cameraFromPatient.matrix(), was.wirePaths[i].cameraFromPatient.matrix());
    }
    EXPECT_FALSE(is.trustworthy);
    EXPECT_EQ(is.probabilityWithin2Mm, was.probabilityWithin2Mm);
    EXPECT_EQ(is.warnings, was.warnings);   // ids, severities and numbers, so that they can be shown in any language
    EXPECT_EQ(is.time.totalMs, 6.5);
    EXPECT_EQ(is.provenance.author, "Ada");
    EXPECT_EQ(is.provenance.time, was.provenance.time);
    EXPECT_EQ(is.provenance.options, was.provenance.options);
    EXPECT_EQ(is.provenance.frame, 0);
    ASSERT_EQ(is.history.size(), 2U);
    EXPECT_EQ(is.history[0].stage, "refine");
    EXPECT_EQ(is.history[0].medianDistancePx, was.history[0].medianDistancePx);
    EXPECT_EQ(is.history[1].view, 1U);
    EXPECT_FALSE(test::anyContains(small.warnings, "Register again"));

    ASSERT_TRUE(io::saveCase(copy, small.path("again.angiopose")));
    EXPECT_EQ(test::readText(small.path("again.angiopose")), test::readText(small.path("saved.angiopose")));
    EXPECT_TRUE(io::validateCase(small.path("saved.angiopose")).value().empty());
}

TEST_F(CaseResult, KeepsTheDeformedVessels)
{
    const core::DeformableResult was = richDeformation(session);
    session.shown().result->deformed = std::make_shared<const core::DeformableResult>(was);
    ASSERT_TRUE(io::saveCase(session, small.path("saved.angiopose")));
    const core::Case copy = reopened();
    ASSERT_TRUE(copy.shown().result && copy.shown().result->deformed);
    const core::DeformableResult& is = *copy.shown().result->deformed;
    EXPECT_EQ(is.verdict, was.verdict);
    EXPECT_EQ(is.cameraFromPatient.matrix(), was.cameraFromPatient.matrix());
    ASSERT_EQ(is.viewPoses.size(), 2U);
    ASSERT_TRUE(core::isCompatible(*session.vessels.tree, is));
    for (std::size_t b = 0; b < was.branches.size(); ++b) {
        EXPECT_EQ(is.branches[b].displacementMm, was.branches[b].displacementMm);
        EXPECT_EQ(is.branches[b].covariance, was.branches[b].covariance);
    }
    EXPECT_EQ(is.rigid.meanMm, 0.7);
    EXPECT_EQ(is.stopReason, core::StopReason::IterationLimit);
    EXPECT_EQ(is.messages, was.messages);
    EXPECT_EQ(io::resultJson(copy, *copy.shown().result), io::resultJson(session, *session.shown().result));
    ASSERT_TRUE(io::writeMotion(*session.vessels.tree, was, small.path("was.csv")));
    ASSERT_TRUE(io::writeMotion(*copy.vessels.tree, is, small.path("is.csv")));
    EXPECT_EQ(test::readText(small.path("is.csv")), test::readText(small.path("was.csv")));

    ASSERT_TRUE(io::saveCase(copy, small.path("again.angiopose")));
    EXPECT_EQ(test::readText(small.path("again.angiopose")), test::readText(small.path("saved.angiopose")));
    EXPECT_TRUE(io::validateCase(small.path("saved.angiopose")).value().empty());
}

TEST_F(CaseResult, WithDeformedVesselsOfAnotherTreeGoes)
{
    core::DeformableResult deformed = richDeformation(session);
    deformed.branches.front().displacementMm.pop_back();
    session.shown().result->deformed = std::make_shared<const core::DeformableResult>(deformed);
    ASSERT_TRUE(io::saveCase(session, small.path("saved.angiopose")));
    EXPECT_FALSE(reopened().shown().result);
    EXPECT_TRUE(test::anyContains(small.warnings, "Register again"));
}

TEST_F(CaseResult, GoesWithThePoseItFound)
{
    nlohmann::json edited = saved();
    edited["pose"]["current"]["cameraFromPatient"][0][3] = 1.0;
    small.folder().write("saved.angiopose", edited.dump());
    EXPECT_FALSE(reopened().shown().result);
}

TEST_F(CaseResult, GoesWithASentenceWhereItsInputsHaveChanged)
{
    for (const char* const input : {"in/tree.csv", "in/image.png"}) {
        const std::string before = test::readText(small.path(input));
        if (std::string(input) == "in/tree.csv") {
            small.folder().write(input, before + "10,16,0,2\n");
        } else {
            core::ColorImage other{16, 12, std::vector<std::uint8_t>(16 * 12 * 3, 70)};
            ASSERT_TRUE(io::writePng(other, small.path(input)));
        }
        EXPECT_FALSE(reopened().shown().result) << input;
        EXPECT_TRUE(test::anyContains(small.warnings, "Register again")) << input;
        small.folder().write(input, before);
        EXPECT_TRUE(reopened().shown().result) << input;
    }
}

TEST_F(CaseResult, OfFilesThatNobodyVouchesForGoes)
{
    nlohmann::json edited = saved();
    edited["angiogram"]["image"].erase("sha256");
    small.folder().write("saved.angiopose", edited.dump());
    EXPECT_FALSE(reopened().shown().result);
}

TEST_F(CaseResult, KeepsWarningsOfOtherVersionsAsTheirSentence)
{
    nlohmann::json edited = saved();
    edited["result"]["messages"][1] = {{"id", "trust.of-the-future"},
                                       {"severity", "warning"},
                                       {"text", "The moon was in the way."},
                                       {"arguments", {1, 2, 3}}};
    small.folder().write("saved.angiopose", edited.dump());
    const core::Case copy = reopened();
    ASSERT_TRUE(copy.shown().result);
    EXPECT_EQ(copy.shown().result->warnings[1].text(), "The moon was in the way.");
}

TEST_F(CaseResult, ThatMakesNoSenseIsRefusedInWords)
{
    for (const auto& [key, value] : std::initializer_list<std::pair<const char*, nlohmann::json>>{
             {"trustworthy", "yes"},
             {"stopReason", "tired"},
             {"messages", {{{"text", "no id"}}}},
             {"uncertainty", {{"covariance", {{1.0}}}}},
             {"metrics", {{"medianProjectionDistancePx", "far"}}}}) {
        nlohmann::json edited = saved();
        edited["result"][key] = value;
        small.folder().write("saved.angiopose", edited.dump());
        core::Messages warnings;
        EXPECT_FALSE(io::loadCase(small.path("saved.angiopose"), warnings)) << key;
    }
}

}   // namespace
