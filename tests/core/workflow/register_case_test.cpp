#include "core/workflow/register_case.h"

#include "core/registration/deformable/deformed_tree.h"

#include "core/geometry/angle_units.h"
#include "core/geometry/rigid_transform.h"
#include "core/messages/messages.h"
#include "tests/support/simulated_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace angiopose::core {
namespace {

using Views = RegistrationPlan::Views;

TEST(ProgressReporter, NeverFallsAndRemembersAStop)
{
    std::vector<double> reported;
    const WorkObserver observe = [&reported](const WorkReport& report) {
        reported.push_back(report.fraction);
        return reported.size() < 4 ? ObserverDecision::Continue : ObserverDecision::Stop;
    };
    ProgressReporter progress(observe);
    progress.enter(0.5, 1.0, 3);
    EXPECT_EQ(progress.report("a", 0.5), ObserverDecision::Continue);
    progress.enter(0.0, 0.5, 3);   // out of order
    EXPECT_EQ(progress.report("b", 1.0), ObserverDecision::Continue);
    progress.enter(0.0, 1.0, 3);
    EXPECT_EQ(progress.report("b", 7.0), ObserverDecision::Continue);
    EXPECT_EQ(progress.report("b", 1.0), ObserverDecision::Stop);
    EXPECT_EQ(progress.report("b", 1.0), ObserverDecision::Stop);
    EXPECT_EQ(reported, (std::vector{0.75, 0.75, 1.0, 1.0}));
    EXPECT_TRUE(progress.isStopped());
}

TEST(RegisterCase, TellsOfEachViewAndItsProgressNeverFalls)
{
    Case values = test::twoViewCase();
    values.shownView = 1;
    double last = 0.0;
    bool hasFallen = false;
    std::set<std::size_t> views;
    const auto run = registerCase(values, {}, [&](const WorkReport& report) {
        hasFallen = hasFallen || report.fraction < last;
        last = report.fraction;
        if (report.iteration) {   // the pose belongs to that view: the tree is in front of its camera
            views.insert(report.view);
            const RigidTransform& pose = report.iteration->cameraFromPatient;
            EXPECT_LT((pose.translation - values.views[report.view].cameraFromPatient.translation).norm(), 150.0);
        }
        return ObserverDecision::Continue;
    });
    ASSERT_TRUE(run) << run.error().message;
    EXPECT_FALSE(hasFallen);
    EXPECT_EQ(views, (std::set<std::size_t>{0, 1}));
    EXPECT_EQ(run.value().viewIndices, (std::vector<std::size_t>{1, 0}));
    ASSERT_TRUE(run.value().joint);
    for (const View& view : run.value().session.views) {
        ASSERT_TRUE(view.result);
        EXPECT_LT(view.result->metrics.medianPx, 1.0);
        EXPECT_EQ(view.cameraFromPatient.matrix(), view.result->cameraFromPatient.matrix());
    }
    EXPECT_EQ(run.value().result().uncertainty.covariance, run.value().joint->uncertainty.covariance);
}

TEST(RegisterCase, CallsTheViewsByTheirPlaceWhicheverIsShown)
{
    Case values = test::twoViewCase();
    Eigen::Matrix3d& start = values.views[0].initialCameraFromPatient->rotation;
    start = expSo3({0.0, 5.0 * radiansPerDegree, 0.0}) * start;   // the geometry between the views is now wrong
    for (std::size_t shown : {0, 1}) {
        values.shownView = shown;
        const auto run = registerCase(values);
        ASSERT_TRUE(run) << run.error().message;
        const std::string other =
            shown == 0 ? "view 2" : "view 1";   // its geometry is reported relative to the shown one
        const Messages& warnings = run.value().joint->warnings;
        EXPECT_TRUE(std::ranges::any_of(warnings, [&](const Message& warning) {
            return warning.id() == messages::viewFarFromHeader(1).id() &&
                   warning.text().find(other) != std::string::npos;
        })) << shown;
    }
}

TEST(RegisterCase, TrustsNoFitOfDifferentPatientsUnlessSomebodyMadeSure)
{
    const auto of = [](View& view, const std::string& number, const std::string& accession) {
        Angiogram run = *view.angiogram;
        run.identity.patientId = number;
        run.identity.accessionNumber = accession;
        view.angiogram = std::make_shared<const Angiogram>(std::move(run));
    };
    Case values = test::twoViewCase();
    of(values.views[0], "0815", "A1");
    of(values.views[1], "0815", "A2");   // another examination of the same patient
    ASSERT_TRUE(registerCase(values).value().result().trustworthy);

    of(values.views[1], "4711", "A1");
    const RegisteredCase other = registerCase(values).value();
    EXPECT_FALSE(other.joint->trustworthy);
    EXPECT_EQ(other.joint->warnings.front().id(), "patient.of-runs-differs");
    for (const View& view : other.session.views) {
        EXPECT_FALSE(view.result->trustworthy);
        EXPECT_EQ(view.result->warnings.front().id(), "patient.of-runs-differs");
    }
    Case sure = values;
    sure.views[1].isSamePatient = true;
    EXPECT_TRUE(registerCase(sure).value().result().trustworthy);
    EXPECT_TRUE(registerCase(values, {.views = Views::Shown}).value().result().trustworthy) << "the other is not used";

    values.vessels.scanIdentity.patientId = "1234";
    const RegistrationResult alone = registerCase(values, {.views = Views::Shown}).value().result();
    EXPECT_FALSE(alone.trustworthy);
    EXPECT_FALSE(alone.probabilityWithin2Mm);
    EXPECT_EQ(alone.warnings.front().id(), "patient.differs");
}

TEST(RegisterCase, TrustsNoViewWhereTheViewsAreNotTrustedTogether)
{
    Case values = test::twoViewCase();
    Centerline2d mirrored = *values.views[0].target.centerline;
    for (Curve2d& curve : mirrored.curves) {
        for (Eigen::Vector2d& point : curve.pointsPx) {
            point.x() = 1000.0 - point.x();
        }
    }
    values.views[0].target.centerline = std::make_shared<const Centerline2d>(std::move(mirrored));
    const RegisteredCase together = registerCase(values).value();
    ASSERT_FALSE(together.joint->trustworthy);
    for (const View& view : together.session.views) {
        EXPECT_FALSE(view.result->trustworthy);
        EXPECT_FALSE(view.result->warnings.empty());
    }
}

/// The case with targets as noisy as traced ones; without noise, every depth would be certain.
Case withNoise(Case values)
{
    CounterRandom random(3);
    for (View& view : values.views) {
        Centerline2d target = *view.target.centerline;
        for (Curve2d& curve : target.curves) {
            for (Eigen::Vector2d& point : curve.pointsPx) {
                point += 0.3 * Eigen::Vector2d(random.normal(), random.normal());
            }
        }
        view.target.centerline = std::make_shared<const Centerline2d>(std::move(target));
    }
    return values;
}

TEST(RegisterCase, TakesOneViewAloneWhereThatIsWanted)
{
    const Case values = withNoise(test::twoViewCase());
    const auto together = registerCase(values);
    const auto alone = registerCase(values, {Views::Shown});
    ASSERT_TRUE(together && alone);
    EXPECT_FALSE(alone.value().joint);
    EXPECT_FALSE(alone.value().session.views[1].result);
    EXPECT_EQ(alone.value().session.views[1].cameraFromPatient.matrix(), values.views[1].cameraFromPatient.matrix());
    EXPECT_GT(alone.value().result().uncertainty.depthMm, together.value().result().uncertainty.depthMm);
}

/// The case with the source assumed to be farther away than it is.
Case withFarSource(Case values, double factor)
{
    for (View& view : values.views) {
        view.geometry.cameraOverride->fx *= factor;
        view.geometry.cameraOverride->fy *= factor;
    }
    return values;
}

double focalPx(const Case& values)
{
    return cameraOf(values.shown()).value().fy;
}

TEST(RegisterCase, EstimatesTheGeometryThatImagesContradictWhereThatIsWanted)
{
    const Case exact = withNoise(test::twoViewCase());
    Case wrong = withFarSource(exact, 1.1);
    const auto asGiven = registerCase(wrong);
    wrong.options.geometry.estimate = true;
    const auto estimated = registerCase(wrong);
    const auto right = registerCase(exact);
    ASSERT_TRUE(asGiven && estimated && right);
    EXPECT_EQ(focalPx(asGiven.value().session), focalPx(wrong));
    EXPECT_NEAR(focalPx(estimated.value().session) / focalPx(exact), 1.0, 0.06);
    const auto depthOf = [](const RegisteredCase& run) { return run.result().cameraFromPatient.translation.z(); };
    EXPECT_LT(std::abs(depthOf(estimated.value()) - depthOf(right.value())),
              0.5 * std::abs(depthOf(asGiven.value()) - depthOf(right.value())));
    const auto isSaid = [](const RegisteredCase& run) {
        return std::ranges::any_of(run.joint->warnings, [](const Message& each) {
            return each.text().find("was estimated from the") != std::string::npos;
        });
    };
    EXPECT_TRUE(isSaid(estimated.value()));
    EXPECT_FALSE(isSaid(asGiven.value()));
}

TEST(RegisterCase, LeavesAGeometryThatIsRightAsItIs)
{
    Case values = withNoise(test::twoViewCase());
    values.options.geometry.estimate = true;
    const auto run = registerCase(values);
    ASSERT_TRUE(run);
    EXPECT_EQ(focalPx(run.value().session), focalPx(values));
}

TEST(RegisterCase, TellsWhatReadingAndTracingTook)
{
    const Case values = test::twoViewCase();
    const auto traced = registerCase(values, {.views = Views::Shown, .readMs = 12.0});
    ASSERT_TRUE(traced) << traced.error().message;
    EXPECT_EQ(traced.value().result().time.readMs, 12.0);
    EXPECT_GE(traced.value().result().time.traceMs, 0.0);
    const auto known = registerCase(values, {.views = Views::Shown, .shownTarget = traced.value().targets.front()});
    ASSERT_TRUE(known) << known.error().message;
    EXPECT_TRUE(std::isnan(known.value().result().time.traceMs));
    EXPECT_TRUE(std::isnan(known.value().result().time.readMs));
}

TEST(RegisterCase, SaysWhichViewHasNoImage)
{
    Case values = test::twoViewCase();
    values.views[1].angiogram = nullptr;
    values.views[1].imageFile.path = "lost.dcm";
    const auto all = registerCase(values);
    ASSERT_FALSE(all);
    EXPECT_NE(all.error().message.text().find("lost.dcm"), std::string::npos);
    const auto loaded = registerCase(values, {Views::Loaded});
    ASSERT_TRUE(loaded);
    EXPECT_EQ(loaded.value().viewIndices, std::vector<std::size_t>{0});
}

TEST(RegisterCase, HearsStopInEveryView)
{
    const Case values = test::twoViewCase();
    const auto stopped = registerCase(values, {}, [](const WorkReport&) { return ObserverDecision::Stop; });
    EXPECT_TRUE(stopped.isStopped());   // before any pose exists
    for (const std::size_t view : {0U, 1U}) {
        int late = 0;
        bool isSaid = false;
        const auto kept = registerCase(values, {}, [&](const WorkReport& report) {
            late += isSaid ? 1 : 0;
            isSaid = isSaid || (report.iteration && report.view == view);
            return isSaid ? ObserverDecision::Stop : ObserverDecision::Continue;
        });
        ASSERT_TRUE(kept) << kept.error().message;
        EXPECT_EQ(late, 0);
        EXPECT_EQ(kept.value().result().stopReason, StopReason::StoppedByUser);
        EXPECT_TRUE(isRigid(kept.value().session.shown().cameraFromPatient));
    }
}

TEST(RegisterCase, UsesTheKnownTargetOfTheShownView)
{
    Case values = test::twoViewCase();
    const Centerline2d known = *values.shown().target.centerline;
    values.shown().target = {};
    Angiogram blank;   // cannot be traced
    blank.frames = {ImageF(values.shown().angiogram->width(), values.shown().angiogram->height(), 1.0F)};
    values.shown().angiogram = std::make_shared<const Angiogram>(std::move(blank));
    EXPECT_FALSE(registerCase(values, {Views::Shown}));
    EXPECT_TRUE(registerCase(values, {Views::Shown, known}));
}

TEST(RegisterCase, DeformationsTheVesselsWhereTheOptionAsksForIt)
{
    Case values = test::twoViewCase();
    const RegistrationPlan plan;
    values.options.deformation = Deformation::Always;
    double last = 0.0;
    bool hasDeformed = false;
    const auto run = registerCase(values, plan, [&](const WorkReport& report) {
        EXPECT_GE(report.fraction, last);
        last = report.fraction;
        hasDeformed = hasDeformed || report.stage == "bending";
        return ObserverDecision::Continue;
    });
    ASSERT_TRUE(run) << run.error().message;
    EXPECT_TRUE(hasDeformed);
    ASSERT_TRUE(run.value().result().deformed);
    for (const View& view : run.value().session.views) {   // each stores it with its own view as the first
        ASSERT_TRUE(view.result->deformed);
        EXPECT_TRUE(isCompatible(*values.vessels.tree, *view.result->deformed));
        ASSERT_EQ(view.result->deformed->viewPoses.size(), 2u);
        EXPECT_EQ(view.result->deformed->cameraFromPatient.matrix(), view.result->deformed->viewPoses[0].matrix());
        const Eigen::Vector3d centroid = centroidInPatient(*values.vessels.tree);
        EXPECT_LT((view.result->deformed->cameraFromPatient * centroid - view.cameraFromPatient * centroid).norm(),
                  2.0);
    }
    Case rigid = values;
    rigid.options.deformation = Deformation::Off;
    EXPECT_FALSE(registerCase(rigid, {}).value().result().deformed);

    // Stopped during the deformation: the rigid pose is kept but marked not reliable, because its check was incomplete.
    const auto stopped = registerCase(values, plan, [](const WorkReport& report) {
        return report.stage == "bending" ? ObserverDecision::Stop : ObserverDecision::Continue;
    });
    ASSERT_TRUE(stopped);
    EXPECT_EQ(stopped.value().result().stopReason, StopReason::StoppedByUser);
    EXPECT_FALSE(stopped.value().result().trustworthy);
    EXPECT_EQ(stopped.value().result().deformed->stopReason, StopReason::StoppedByUser);

    // Stopped earlier: the deformation was not started.
    const auto early = registerCase(values, plan, [](const WorkReport& report) {
        return report.iteration ? ObserverDecision::Stop : ObserverDecision::Continue;
    });
    ASSERT_TRUE(early);
    EXPECT_FALSE(early.value().result().deformed);
}

}   // namespace
}   // namespace angiopose::core
