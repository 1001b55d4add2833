#include "core/registration/deformable/deformation_problem.h"

#include "core/geometry/angle_units.h"
#include "core/messages/messages.h"
#include "core/registration/problem/in_view.h"
#include "core/registration/problem/registration_problem.h"

#include <algorithm>

namespace angiopose::core {
namespace {

std::size_t viewNumber(std::span<const DeformableView> views, std::size_t index)
{
    return views[index].number > 0 ? views[index].number : index + 1;
}

/// Builds the target of a view and its camera position relative to the first view; fails if the view is unusable.
Result<DeformationView> makeDeformationView(const DeformableView& view, const RigidTransform& firstPose)
{
    RegistrationInput input = view.input;
    input.initialCameraFromPatient = view.rigidCameraFromPatient;
    const auto problem = makeProblem(input, {});
    if (!problem) {
        return problem.error();
    }
    CurveCrossings curves(problem.value().target, input.camera);
    if (!curves.hasCurves()) {
        return Error(messages::deformationNeedsCurves());
    }
    return DeformationView{input.camera, view.rigidCameraFromPatient * firstPose.inverse(), std::move(curves)};
}

Matrix6d independentVariances(double turnDeg, double shiftMm)
{
    Vector6d deviations;
    deviations << Eigen::Vector3d::Constant(turnDeg / degreesPerRadian), Eigen::Vector3d::Constant(shiftMm);
    return deviations.cwiseAbs2().asDiagonal();
}

/// Returns the prior of the step from the rigid to the true pose, based on the initial pose alone.
GaussianEstimate stepByStart(const CentroidPose& rigid, const RegistrationInput& input,
                             const DeformableOptions& options)
{
    Vector6d deviations;
    deviations << Eigen::Vector3d::Constant(options.startDeg / degreesPerRadian), options.startLateralMm,
        options.startLateralMm, options.startDepthMm;
    return {stepBetween(rigid, aboutCentroid(input.initialCameraFromPatient, centroidInPatient(input.tree))),
            deviations.cwiseAbs2().asDiagonal()};
}

TreeKnots knotsOf(const RegistrationInput& input, const DeformableOptions& options)
{
    double lengthMm = 0.0;
    for (const VesselBranch& branch : input.tree.branches) {
        lengthMm += branch.lengthMm();
    }
    return treeKnots(input.tree, input.excludedBranchIds, std::max(options.knotSpacingMm, lengthMm / options.maxKnots));
}

}   // namespace

Result<DeformationProblem> makeDeformationProblem(std::span<const DeformableView> views,
                                                  const DeformableOptions& options)
{
    if (views.empty()) {
        return Error(messages::deformationNoView());
    }
    if (!(options.posePriorDeg > 0.0 && options.posePriorMm > 0.0 && options.startDeg > 0.0 &&
          options.startLateralMm > 0.0 && options.startDepthMm > 0.0 && options.knotSpacingMm > 0.0 &&
          options.maxKnots > 0 && options.geometryDeg >= 0.0 && options.geometryMm >= 0.0)) {
        return Error(messages::deformationOptionsUnusable());
    }
    const DeformableView& first = views.front();
    std::vector<DeformationView> deformationViews;
    for (std::size_t k = 0; k < views.size(); ++k) {
        auto view = makeDeformationView(views[k], first.rigidCameraFromPatient);
        if (!view) {
            return views.size() > 1 ? inView(viewNumber(views, k), view.error()) : view.error();
        }
        if (views[k].input.tree.pointCount() != first.input.tree.pointCount() ||
            views[k].input.tree.branches.size() != first.input.tree.branches.size()) {
            return Error(messages::viewsOfOtherTree(viewNumber(views, k), viewNumber(views, 0)));
        }
        deformationViews.push_back(std::move(view).value());
    }
    TreeKnots knots = knotsOf(first.input, options);
    FieldKernel kernel(knots);
    const Eigen::Vector3d centroid = centroidInPatient(first.input.tree);
    const CentroidPose rigid = aboutCentroid(first.rigidCameraFromPatient, centroid);
    const MotionPrior prior{.pose = independentVariances(options.posePriorDeg, options.posePriorMm),
                            .geometry = independentVariances(options.geometryDeg, options.geometryMm)};
    return DeformationProblem{std::move(knots),
                              std::move(kernel),
                              std::move(deformationViews),
                              centroid,
                              rigid,
                              prior,
                              stepByStart(rigid, first.input, options)};
}

Status replaceView(DeformationProblem& problem, const DeformableView& view, const DeformableOptions& options)
{
    auto made = makeDeformationView(view, view.rigidCameraFromPatient);
    if (!made) {
        return made.error();
    }
    problem.views.assign(1, std::move(made).value());
    problem.start = aboutCentroid(view.rigidCameraFromPatient, problem.centroidInPatient);
    problem.startStep = stepByStart(problem.start, view.input, options);
    return Done{};
}

}   // namespace angiopose::core
