#include "app/cli/register_outputs.h"
#include "app/report/case_report.h"
#include "app/run_controller.h"
#include "app/step_states.h"
#include "core/registration/judging/unopacified_branches.h"
#include "core/workflow/pose_evaluation.h"
#include "core/workflow/register_case.h"
#include "io/results/result_file.h"
#include "tests/support/simulated_views.h"
#include "ui/panels/result_panel.h"
#include "ui/panels/result_sentences.h"
#include "ui/scenes/vector_image.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace angiopose::app {
namespace {

/// A registration whose pose must be reported as unreliable.
struct BadFit {
    const char* name;
    core::RegisteredCase found;
};

core::Case sampleCase(std::uint64_t seed)
{
    return test::caseOf(core::simulateCase(seed));
}

core::Case withTarget(core::Case values, core::Centerline2d target)
{
    values.shown().target.centerline = std::make_shared<const core::Centerline2d>(std::move(target));
    return values;
}

/// Replaces the tree by that of another patient, at the same place.
core::Case ofForeignTree()
{
    core::Case values = sampleCase(2);
    core::VesselTree other = core::simulateCase(9).tree;
    const Eigen::Vector3d shift = core::centroidInPatient(*values.vessels.tree) - core::centroidInPatient(other);
    for (core::VesselBranch& branch : other.branches) {
        for (Eigen::Vector3d& point : branch.pointsInPatient) {
            point += shift;
        }
    }
    values.vessels.tree = std::make_shared<const core::VesselTree>(std::move(other));
    return values;
}

/// The tree flattened into a plane through the source and shifted along the line that this plane forms in the image.
core::Case seenEdgeOn()
{
    const core::SimulatedCase simulated = core::simulateCase(3);
    core::Case values = test::caseOf(simulated);
    core::VesselTree flat = simulated.tree;
    const core::RigidTransform& pose = simulated.trueCameraFromPatient;
    for (core::VesselBranch& branch : flat.branches) {
        for (Eigen::Vector3d& point : branch.pointsInPatient) {
            Eigen::Vector3d inCamera = pose * point;
            inCamera.x() = 0.0;
            point = pose.inverse() * inCamera;
        }
    }
    values.vessels.tree = std::make_shared<const core::VesselTree>(flat);
    core::View& view = values.shown();
    view.initialCameraFromPatient = pose;
    view.initialCameraFromPatient->translation += Eigen::Vector3d(2.0, 5.0, 5.0);
    view.cameraFromPatient = *view.initialCameraFromPatient;
    return withTarget(values, core::projectTree(flat, simulated.camera, pose));
}

core::Case ofOnePath()
{
    const core::SimulatedCase simulated = core::simulateCase(4);
    core::Centerline2d path;
    path.curves = {simulated.trueTarget.curves.front()};
    path.curves.front().radiusPx.clear();
    return withTarget(test::caseOf(simulated), path);
}

core::Case ofOtherThings()
{
    core::Case values = sampleCase(5);
    core::Centerline2d arcs;
    for (int k = 0; k < 6; ++k) {
        core::Curve2d arc{k + 1, {}, {}};
        for (int i = 0; i < 400; ++i) {
            arc.pointsPx.emplace_back(50.0 + i, 60.0 + 70.0 * k + 0.0004 * (i - 200) * (i - 200));
        }
        arcs.curves.push_back(arc);
    }
    return withTarget(values, arcs);
}

core::Case ofTwoPatients()
{
    core::Case values = sampleCase(6);
    core::Angiogram run = *values.shown().angiogram;
    run.identity.patientId = "4711";
    values.shown().angiogram = std::make_shared<const core::Angiogram>(std::move(run));
    values.vessels.scanIdentity.patientId = "0815";
    return values;
}

std::vector<BadFit> badFits()
{
    const core::WorkObserver stop = [](const core::WorkReport& report) {
        return report.iteration ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    };
    std::vector<BadFit> fits;
    fits.push_back({"foreign tree", core::registerCase(ofForeignTree()).value()});
    fits.push_back({"seen edge-on", core::registerCase(seenEdgeOn()).value()});
    fits.push_back({"one path", core::registerCase(ofOnePath()).value()});
    fits.push_back({"other things", core::registerCase(ofOtherThings()).value()});
    fits.push_back({"two patients", core::registerCase(ofTwoPatients()).value()});
    fits.push_back({"stopped", core::registerCase(sampleCase(7), {}, stop).value()});
    return fits;
}

void expectDoubtInTheWindow(const core::Case& session)
{
    const core::RegistrationResult& result = *session.shown().result;
    const auto states = stepStates(session, {});
    EXPECT_EQ(states[static_cast<std::size_t>(ui::Step::Register)].mark, ui::StepMark::Attention);
    EXPECT_EQ(states[static_cast<std::size_t>(ui::Step::Review)].mark, ui::StepMark::Attention);
    const ui::FitVerdict verdict = ui::assessFit({result, ui::PoseSource::Run, {}, 0.0, 0.3, 1.0, 0.0, {}});
    EXPECT_EQ(verdict.tone, ui::VerdictTone::Bad);
    EXPECT_TRUE(verdict.sentence.startsWith(QStringLiteral("NOT RELIABLE")));
    const ui::ResultSentences said = ui::sentencesOf(result, *session.vessels.tree, 0.3);
    EXPECT_TRUE(said.certain.isEmpty());
    ASSERT_FALSE(said.doubtful.isEmpty());
    EXPECT_FALSE(said.doubtful.join(u' ').section(QStringLiteral("probability of "), 1).startsWith(u'9'));
}

void expectDoubtInThePicture(const core::Case& session, const core::Centerline2d& target)
{
    const auto picture = drawOverlayVectors(session, target);
    ASSERT_TRUE(picture) << picture.error().message;
    const auto& texts = picture.value().texts;
    const auto verdict = std::ranges::find(texts, "NOT RELIABLE", &ui::VectorText::text);
    ASSERT_NE(verdict, texts.end());
    EXPECT_EQ(verdict->tone.hex(), ui::palette(ui::ThemeMode::Dark).attention.hex());
    EXPECT_EQ(provenanceTexts(session).at("Trustworthy"), "no");
}

void expectDoubtInTheReport(const core::Case& session, const core::Centerline2d& target)
{
    const auto views = evaluateViews(session, target, {});
    ASSERT_TRUE(views) << views.error().message;
    const auto page = reportBytes({views.value(), {}, {}, {}}, ReportKind::Html);
    ASSERT_TRUE(page) << page.error().message;
    EXPECT_TRUE(page.value().contains("NOT RELIABLE"));
    EXPECT_FALSE(page.value().contains(">Reliable<"));
    EXPECT_FALSE(page.value().contains("#e3f2e6")) << "the ground of what is certain";
    EXPECT_LT(page.value().indexOf("NOT RELIABLE"), page.value().lastIndexOf("base64")) << "before the picture";
}

void expectDoubtInWords(const core::RegisteredCase& found)
{
    EXPECT_TRUE(RunController::finishedText(found.result()).contains(QStringLiteral("NOT RELIABLE")));
    ::testing::internal::CaptureStdout();
    printSummary(found, "out");
    const std::string printed = ::testing::internal::GetCapturedStdout();
    EXPECT_TRUE(printed.starts_with("trustworthy    NO: NOT RELIABLE")) << printed;
    EXPECT_EQ(printed.find("yes"), std::string::npos) << printed;
}

std::string wordsIn(const core::RegisteredCase& found)
{
    const auto picture = drawOverlayVectors(found.session, found.targets.front());
    std::string sentence;
    for (const ui::VectorText& text : picture.value().texts) {
        sentence += text.text + "\n";
    }
    return sentence;
}

TEST(LowConfidence, LooksSoWhereverAResultIsShown)
{
    for (const BadFit& fit : badFits()) {
        SCOPED_TRACE(fit.name);
        const core::Case& session = fit.found.session;
        const core::RegistrationResult& result = fit.found.result();
        ASSERT_FALSE(result.trustworthy);
        ASSERT_FALSE(result.warnings.empty());
        EXPECT_LT(result.probabilityWithin2Mm.value_or(0.0), 0.8);
        expectDoubtInTheWindow(session);
        expectDoubtInWords(fit.found);
        expectDoubtInThePicture(session, fit.found.targets.front());
        expectDoubtInTheReport(session, fit.found.targets.front());
        const auto json =
            nlohmann::json::parse(io::resultJson(fit.found, fit.found.viewIndices.front(), io::ResultTexts::Kept));
        EXPECT_FALSE(json["trustworthy"].get<bool>());
        EXPECT_FALSE(json["warnings"].empty());
    }
}

TEST(LowConfidence, NamesWhatItsDistancesAreAbout)
{
    core::Case values = sampleCase(8);
    core::Centerline2d part = *values.shown().target.centerline;
    part.curves.resize(std::max<std::size_t>(2, part.curves.size() / 3));   // the rest is not opacified
    const core::RegisteredCase found = core::registerCase(withTarget(values, part)).value();
    const core::RegistrationResult& result = found.result();
    ASSERT_FALSE(result.unopacified.empty());
    const double share = core::assessedFraction(result);
    EXPECT_GT(share, 0.0);
    EXPECT_LT(share, 1.0);
    const auto basis = core::fitBasis(found.session, result, found.targets.front());
    ASSERT_TRUE(basis);
    EXPECT_EQ(basis->assessedFraction, share);
    EXPECT_GT(basis->wholeMedianMm, 3.0 * result.metrics.medianMm) << "most of the tree lies on no vessel";

    const QString sentence =
        ui::assessFit({result, ui::PoseSource::Run, {}, 0.0, 0.3, share, basis->wholeMedianMm, {}}).sentence;
    EXPECT_TRUE(sentence.contains(QStringLiteral("over the %1 %").arg(qRound(100.0 * share))))
        << sentence.toStdString();
    EXPECT_TRUE(sentence.contains(QStringLiteral("whole tree"))) << sentence.toStdString();
    const std::string reported = wordsIn(found);
    EXPECT_NE(reported.find("classified as opacified. Whole tree: median"), std::string::npos) << reported;
}

TEST(LowConfidence, NamesExcludedBranchesAndTheValueWithThem)
{
    core::Case values = sampleCase(10);
    const int excluded = values.vessels.tree->branches.back().id;
    values.vessels.excludedBranchIds = {excluded};
    values.vessels.auxiliaryBranchIds = {values.vessels.tree->branches.front().id};
    const core::RegisteredCase found = core::registerCase(values).value();
    const std::string reported = wordsIn(found);
    const core::VesselBranch& branch = values.vessels.tree->branches.back();
    const std::string name = branch.name.empty() ? std::to_string(excluded) : branch.name;
    EXPECT_NE(reported.find("Excluded branches: " + name + ": "), std::string::npos) << reported;
    const std::string auxiliary = reported.substr(reported.find("Auxiliary branches: "));
    EXPECT_NE(auxiliary.find(" mm (medians)"), std::string::npos) << reported;
}

}   // namespace
}   // namespace angiopose::app
