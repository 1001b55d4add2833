#include "app/texts/pose_origin.h"
#include "tests/app/open_window.h"
#include "ui/panels/result_sentences.h"

#include <QListWidget>

namespace angiopose::app {
namespace {

using test::OpenWindow;

/// The sample after a registration that found two paths of a guidewire.
struct WireWindow : OpenWindow {
    WireWindow()
    {
        openSample();
        core::Case found = current();
        core::RegistrationResult result = controller.evaluation()->result;
        const core::RigidTransform pose = found.shown().cameraFromPatient;
        other = pose;
        other.translation.x() += 4.0;
        result.method = "wire";
        result.cameraFromPatient = pose;
        result.wirePaths = {{{1, 3, 7, 9}, Eigen::Vector3d::Zero(), 0.71, 1.3, 0.96, pose, {}},
                            {{1, 2}, Eigen::Vector3d::Zero(), 0.24, 1.8, 0.82, other, {}}};
        result.alternatives = {{other, 0.24}};
        result.metrics.medianPx = 0.75;
        for (core::BranchResidual& branch : result.branches) {
            branch.medianPx = 100.0;
        }
        found.shown().result = std::move(result);
        controller.document().replace(std::move(found), {});
        waitForJudgement();
    }

    QListWidget& ways() { return *window.result().solutions().list(); }

    core::RigidTransform other;
};

TEST(WindowWire, ListsTheWaysWithTheirProbabilities)
{
    WireWindow w;
    ASSERT_EQ(w.ways().count(), 2);
    EXPECT_TRUE(w.window.result().solutions().isVisible());
    EXPECT_EQ(w.ways().item(0)->text(), QStringLiteral("71 %: 1 › … › 9"));
    EXPECT_EQ(w.ways().item(1)->text(), QStringLiteral("24 %: 1 › 2"));
    EXPECT_TRUE(w.ways().item(0)->toolTip().contains(QStringLiteral("1, 3, 7, 9")))
        << w.ways().item(0)->toolTip().toStdString();
    EXPECT_TRUE(w.ways().item(1)->toolTip().contains(QStringLiteral("82 % of the guidewire")));
}

TEST(WindowWire, TellsTheFiguresOfTheWayAlone)
{
    WireWindow w;
    core::RegistrationResult evaluated = w.controller.evaluation()->result;
    EXPECT_EQ(addRegistrationResult(evaluated, w.current().shown()), PoseOrigin::Registration);
    EXPECT_EQ(evaluated.metrics.medianPx, 0.75);
    const QString words = ui::sentencesOf(evaluated, *w.current().vessels.tree, 1.0).doubtful.join(QLatin1Char(' '));
    EXPECT_TRUE(words.contains(QStringLiteral("4 branches are up to"))) << words.toStdString();
}

TEST(WindowWire, TakesTheChosenWayAndUndoesIt)
{
    WireWindow w;
    const core::RigidTransform before = w.current().shown().cameraFromPatient;
    w.ways().setCurrentRow(1);
    EXPECT_EQ(w.controller.preview().shown(), PreviewSource::Solution);
    EXPECT_EQ(test::distance(w.current().shown().cameraFromPatient, before), 0.0) << "looked at, not taken";
    w.press(Qt::Key_J, Qt::ShiftModifier);
    EXPECT_EQ(test::distance(w.current().shown().cameraFromPatient, w.other), 0.0);
    w.controller.document().undo();
    EXPECT_EQ(test::distance(w.current().shown().cameraFromPatient, before), 0.0);
    ASSERT_TRUE(w.current().shown().result);
    EXPECT_EQ(w.current().shown().result->wirePaths.size(), 2U);
}

TEST(WindowWire, JudgesTheFollowedBranchesByTheWireThatIsKeptApart)
{
    WireWindow w;
    core::Case wire = w.current();
    const core::ProjectionCamera camera = core::cameraOf(wire.shown()).value();
    const auto longest = std::ranges::max_element(wire.vessels.tree->branches, {}, &core::VesselBranch::lengthMm);
    core::Curve2d course{1, {}, {}};
    for (const Eigen::Vector3d& point : longest->pointsInPatient) {
        course.pointsPx.push_back(*core::project(camera, wire.shown().cameraFromPatient * point));
    }
    const core::Curve2d vessel{2, {{2.0, 2.0}, {12.0, 2.0}, {22.0, 3.0}}, {}};   // in a corner, far from the guidewire
    wire.shown().target.centerline = std::make_shared<const core::Centerline2d>(core::Centerline2d{{vessel}});
    wire.shown().target.devices = std::make_shared<const core::Centerline2d>(core::Centerline2d{{course}});
    wire.shown().target.editedFrame = wire.shown().frame;
    const auto residualPx = [&] {
        const auto& branches = w.controller.evaluation()->result.branches;
        const auto evaluated = std::ranges::find(branches, longest->id, &core::BranchResidual::branchId);
        return evaluated == branches.end() ? -1.0 : evaluated->medianPx;
    };
    const auto show = [&](const char* method) {
        wire.shown().result->method = method;
        w.controller.document().replace(wire, {});
    };
    show("angiopose");
    EXPECT_TRUE(test::waitFor([&] { return residualPx() > 20.0; })) << "a wire is no vessel";
    show("wire");
    EXPECT_TRUE(test::waitFor([&] { return residualPx() >= 0.0 && residualPx() < 2.0; })) << residualPx();
}

TEST(WindowWire, FollowsAWireOnRequest)
{
    test::SampleWindow w;
    core::Case wire = w.current();
    const core::ProjectionCamera camera = core::cameraOf(wire.shown()).value();
    const auto longest = std::ranges::max_element(wire.vessels.tree->branches, {}, &core::VesselBranch::lengthMm);
    core::Centerline2d centerline;
    centerline.curves.emplace_back();
    for (const Eigen::Vector3d& point : longest->pointsInPatient) {
        const Eigen::Vector3d beside = wire.shown().cameraFromPatient * point + Eigen::Vector3d(2.0, 1.0, 0.0);
        centerline.curves.back().pointsPx.push_back(*core::project(camera, beside));
    }
    wire.shown().target.centerline = std::make_shared<const core::Centerline2d>(std::move(centerline));
    wire.shown().target.editedFrame = wire.shown().frame;
    wire.options.method = "wire";
    w.controller.document().replace(std::move(wire), {});
    w.waitForJudgement();
    w.registerVessels();
    ASSERT_TRUE(w.current().shown().result);
    EXPECT_EQ(w.current().shown().result->method, "wire");
    EXPECT_FALSE(w.current().shown().result->wirePaths.empty());
}

}   // namespace
}   // namespace angiopose::app
