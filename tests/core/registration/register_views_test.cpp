#include "core/registration/register_views.h"

#include "core/evaluation/trial/projection_error.h"
#include "core/geometry/angle_units.h"
#include "core/registration/alignment/joint_solver.h"
#include "core/registration/deformable/deform_vessels.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <array>
#include <cmath>

namespace angiopose::core {
namespace {

/// A tree in two views, the second rotated by 70° about the tree, with noisy target points.
struct TwoViews {
    TwoViews()
    {
        const Eigen::Vector3d centroid = centroidInPatient(clean.tree);
        truth[0] = clean.truth;
        truth[1].rotation = expSo3({0.0, 70.0 * radiansPerDegree, 0.0}) * clean.truth.rotation;
        truth[1].translation = Eigen::Vector3d(-3.0, 5.0, 780.0) - truth[1].rotation * centroid;
        for (std::size_t k = 0; k < 2; ++k) {
            inputs[k] = clean.from(truth[k]);
            inputs[k].target = test::jittered(projectTree(clean.tree, clean.camera, truth[k]), random);
        }
    }

    /// Sets initial poses that keep the geometry between the views but are off by `step` in the first view (about its
    /// centroid).
    void startOff(const Vector6d& step)
    {
        const Eigen::Vector3d centroid = centroidInPatient(clean.tree);
        const RigidTransform off = cameraFromPatient(retract(aboutCentroid(truth[0], centroid), step), centroid);
        inputs[0].initialCameraFromPatient = off;
        inputs[1].initialCameraFromPatient = truth[1] * truth[0].inverse() * off;
    }

    PoseError error(const RigidTransform& pose, std::size_t view) const
    {
        return poseError(centroidInPatient(clean.tree), {pose, truth[view]});
    }

    CounterRandom random{5};
    test::CleanCase clean{3};
    std::array<RigidTransform, 2> truth;
    std::array<RegistrationInput, 2> inputs;
};

Vector6d typicalStep()
{
    Vector6d step;
    step << 3.0 * radiansPerDegree, -2.0 * radiansPerDegree, 2.0 * radiansPerDegree, 8.0, -6.0, 20.0;
    return step;
}

TEST(JointAlignment, StackedGradientIsThatOfTheSum)
{
    const TwoViews two;
    const Eigen::Vector3d centroid = centroidInPatient(two.clean.tree);
    const std::array<RelativeCamera, 2> geometry{RelativeCamera{{}, two.clean.camera},
                                                 {two.truth[1] * two.truth[0].inverse(), two.clean.camera}};
    Vector6d correction;
    correction << 0.02, -0.03, 0.01, 2.0, 1.0, -3.0;
    const JointPose joint{aboutCentroid(two.truth[0], centroid), {Vector6d::Zero(), correction}};

    // Each view prefers another pose: the cost |W (pose ⊖ wish)|² has the gradient W² step at the pose itself.
    const auto costAt = [&](const JointPose& at, std::vector<NormalEquations>& perView) {
        double cost = 0.0;
        perView.clear();
        for (std::size_t k = 0; k < 2; ++k) {
            const CentroidPose request =
                retract(poseInView(joint, geometry, k), (k == 0 ? 0.01 : 0.02) * Vector6d::Ones());
            const Vector6d step = stepBetween(request, poseInView(at, geometry, k));
            cost += step.squaredNorm();
            NormalEquations equations;
            equations.hessian.setIdentity();
            equations.gradient = step;
            perView.push_back(equations);
        }
        return cost;
    };
    std::vector<NormalEquations> perView;
    costAt(joint, perView);
    const StackedEquations sum = stackEquations(perView, joint, geometry);
    std::vector<NormalEquations> ignored;
    for (int i = 0; i < 12; ++i) {
        Eigen::VectorXd step = Eigen::VectorXd::Zero(12);
        step[i] = 1e-5;
        const double difference =
            (costAt(retract(joint, step), ignored) - costAt(retract(joint, -step), ignored)) / 4e-5;
        EXPECT_NEAR(sum.gradient[i], difference, 1e-3 * sum.gradient.norm()) << "parameter " << i;
    }
}

TEST(RegisterViews, DepthBecomesAsCertainAsTheShift)
{
    TwoViews two;
    two.startOff(typicalStep());
    const auto alone = registerVessels(two.inputs[0]);
    const auto both = registerViews(two.inputs, {}, {.steps = {{}, {0.05, {0.05, 0.05, 0.05}}}});
    ASSERT_TRUE(alone && both);
    EXPECT_TRUE(both.value().trustworthy);
    EXPECT_LT(both.value().uncertainty.depthMm, 0.3 * alone.value().uncertainty.depthMm);
    for (std::size_t k = 0; k < 2; ++k) {
        const PoseError error = two.error(both.value().views[k].cameraFromPatient, k);
        EXPECT_LT(std::abs(error.centroidDepthMm), 0.15) << "view " << k + 1;
        EXPECT_LT(error.angleDeg, 0.1) << "view " << k + 1;
    }
}

TEST(RegisterViews, FindsTheErrorOfTheGeometry)
{
    TwoViews two;
    two.startOff(typicalStep());
    const Eigen::Vector3d centroid = centroidInPatient(two.clean.tree);
    Vector6d sag;
    sag << 0.4 * radiansPerDegree, -0.3 * radiansPerDegree, 0.5 * radiansPerDegree, 1.0, -0.8, 0.5;
    const CentroidPose second = aboutCentroid(two.inputs[1].initialCameraFromPatient, centroid);
    two.inputs[1].initialCameraFromPatient = cameraFromPatient(retract(second, -sag), centroid);
    const auto result = registerViews(two.inputs);
    ASSERT_TRUE(result);
    EXPECT_TRUE(result.value().trustworthy);
    const Vector6d found = result.value().corrections[1];
    EXPECT_LT((found - sag).head<3>().norm(), 0.15 * radiansPerDegree);
    EXPECT_LT((found - sag).segment<2>(3).norm(), 0.7);   // shared with the depth in the first view
    EXPECT_EQ(result.value().corrections[0].norm(), 0.0);
}

TEST(RegisterViews, DoubtsViewsThatCannotBelongTogether)
{
    TwoViews two;
    two.startOff(Vector6d::Zero());
    two.inputs[1].initialCameraFromPatient.rotation =
        expSo3({0.0, 5.0 * radiansPerDegree, 0.0}) * two.inputs[1].initialCameraFromPatient.rotation;
    const auto result = registerViews(two.inputs);
    ASSERT_TRUE(result);
    EXPECT_FALSE(result.value().trustworthy);
    EXPECT_FALSE(result.value().warnings.empty());
}

TEST(RegisterViews, ReportsTellTheirViewAndNeverFallBack)
{
    TwoViews two;
    two.startOff(typicalStep());
    IterationReport last;
    const auto result = registerViews(two.inputs, {}, {}, [&](const IterationReport& report) {
        EXPECT_GE(report.progress, last.progress);
        EXPECT_LE(report.progress, 1.0);
        EXPECT_EQ(report.iteration, last.iteration + 1);
        EXPECT_LT(two.error(report.cameraFromPatient, report.view).angleDeg, 30.0) << report.stage << report.iteration;
        last = report;
        return ObserverDecision::Continue;
    });
    ASSERT_TRUE(result);
    EXPECT_EQ(last.stage, "joint");
    EXPECT_GT(last.progress, 0.99);
}

TEST(RegisterViews, AStopEndsTheJointRefinementAtOnce)
{
    TwoViews two;
    two.startOff(typicalStep());
    int reportsAfter = -1;
    const auto result = registerViews(two.inputs, {}, {}, [&](const IterationReport& report) {
        if (reportsAfter >= 0 || report.stage == "joint") {
            ++reportsAfter;
            return ObserverDecision::Stop;
        }
        return ObserverDecision::Continue;
    });
    ASSERT_TRUE(result);
    EXPECT_EQ(reportsAfter, 0);
    EXPECT_EQ(result.value().views.front().stopReason, StopReason::StoppedByUser);
}

// The length of a step is that of the motion it causes in any view: a rejected rotation does not count as converged.
TEST(JointSolver, CountsTurnsAsMotion)
{
    for (const Eigen::Index parameter : {1, 7, 9}) {
        EXPECT_GE(jointStepLengthMm(0.1 * Eigen::VectorXd::Unit(12, parameter), 40.0), 0.1) << parameter;
    }
}

TEST(RegisterViews, NamesWhatIsWrong)
{
    TwoViews two;
    EXPECT_FALSE(registerViews({two.inputs.data(), 1}));
    two.inputs[1].excludedBranchIds = {two.clean.tree.branches.front().id};
    const auto other = registerViews(two.inputs);
    ASSERT_FALSE(other);
    EXPECT_NE(other.error().message.text().find("View 2"), std::string::npos);
    two.inputs[1].excludedBranchIds.clear();
    two.inputs[1].target.curves.clear();
    const auto empty = registerViews(two.inputs);
    ASSERT_FALSE(empty);
    EXPECT_NE(empty.error().message.text().find("View 2"), std::string::npos);
    MultiViewOptions called;
    called.numbers = {3, 1};
    EXPECT_NE(registerViews(two.inputs, {}, called).error().message.text().find("View 1"), std::string::npos);
}

const MultiViewOptions unknownTable{.steps = {RelativePoseStd(), RelativePoseStd{0.75, {60.0, 60.0, 30.0}}}};

/// Two views between which the table moved by an unknown distance; only the rotation is known.
TwoViews withUnknownTable()
{
    TwoViews two;
    two.startOff(typicalStep());
    two.inputs[1].initialCameraFromPatient.translation += Eigen::Vector3d(60.0, -35.0, 40.0);
    return two;
}

TEST(RegisterViews, FindsTheSecondViewWhereverTheTableLeftIt)
{
    const TwoViews two = withUnknownTable();
    const auto joint = registerViews(two.inputs, {}, unknownTable);
    ASSERT_TRUE(joint) << joint.error().message;
    EXPECT_TRUE(joint.value().trustworthy);
    for (std::size_t k = 0; k < 2; ++k) {
        const RigidTransform& found = joint.value().views[k].cameraFromPatient;
        const Eigen::Vector3d centroid = centroidInPatient(two.clean.tree);
        EXPECT_LT((found * centroid - two.truth[k] * centroid).norm(), 2.0) << k;
    }
    EXPECT_GT(joint.value().corrections[1].tail<3>().norm(), 50.0);
    const auto asTaken = registerViews(two.inputs, {}, {});
    ASSERT_TRUE(asTaken);
    EXPECT_FALSE(asTaken.value().trustworthy) << "planes taken together do not lie apart";
}

TEST(RegisterViews, AnUnmeasuredDepthIsNoDeformation)
{
    RegistrationOptions always;
    always.deformation = Deformation::Always;
    const auto joint = registerViews(withUnknownTable().inputs, always, unknownTable);
    ASSERT_TRUE(joint) << joint.error().message;
    ASSERT_TRUE(joint.value().deformed);
    EXPECT_LT(joint.value().deformed->rigid.meanMm, 0.1);   // counted in space it is 0.23
}

}   // namespace
}   // namespace angiopose::core
