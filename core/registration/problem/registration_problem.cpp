#include "core/registration/problem/registration_problem.h"

#include "core/messages/messages.h"
#include "core/registration/problem/auxiliary_points.h"
#include "core/vessel/reordered_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

// Skeleton curves step from pixel to pixel, which makes tangents stable only over several points.
constexpr int targetTangentReach = 3;

void reserve(TreeSamples& samples, std::size_t count)
{
    samples.points.reserve(count);
    samples.tangents.reserve(count);
    samples.radiusMm.reserve(count);
    samples.branchIndex.reserve(count);
}

TreeSamples samplesOf(const VesselTree& tree)
{
    TreeSamples samples;
    reserve(samples, tree.pointCount());
    for (const VesselBranch& branch : tree.branches) {
        const std::vector<Eigen::Vector3d> tangents = tangentsOf(branch.pointsInPatient);
        const std::size_t count = branch.pointsInPatient.size();
        samples.points.insert(samples.points.end(), branch.pointsInPatient.begin(), branch.pointsInPatient.end());
        samples.tangents.insert(samples.tangents.end(), tangents.begin(), tangents.end());
        samples.radiusMm.insert(samples.radiusMm.end(), branch.radiusMm.begin(), branch.radiusMm.end());
        samples.radiusMm.resize(samples.points.size(), 0.0);
        samples.branchIndex.insert(samples.branchIndex.end(), count, static_cast<int>(samples.branchIds.size()));
        samples.branchIds.push_back(branch.id);
    }
    for (const Eigen::Vector3d& point : samples.points) {
        samples.centroid += point / static_cast<double>(samples.size());
    }
    double squares = 0.0;
    for (const Eigen::Vector3d& point : samples.points) {
        squares += (point - samples.centroid).squaredNorm();
    }
    samples.spreadMm = std::max(1e-6, std::sqrt(squares / static_cast<double>(samples.size())));
    return samples;
}

/// Marks the sample nearest to every node, on one of the branches that meet there.
void markNodes(const VesselTree& tree, TreeSamples& samples)
{
    samples.isNode.assign(samples.size(), 0);
    for (const VesselNode& node : findNodes(tree)) {
        const auto branch = std::find(samples.branchIds.begin(), samples.branchIds.end(), node.branchIds.front());
        const auto index = static_cast<int>(branch - samples.branchIds.begin());
        const auto [from, to] = std::equal_range(samples.branchIndex.begin(), samples.branchIndex.end(), index);
        double nearestSquared = std::numeric_limits<double>::infinity();
        std::size_t nearest = 0;
        for (auto i = static_cast<std::size_t>(from - samples.branchIndex.begin());
             i < static_cast<std::size_t>(to - samples.branchIndex.begin()); ++i) {
            const double squared = (samples.points[i] - node.pointInPatient).squaredNorm();
            if (squared < nearestSquared) {
                nearestSquared = squared;
                nearest = i;
            }
        }
        samples.isNode[nearest] = 1;
    }
}

TargetSamples samplesOf(const Centerline2d& target)
{
    TargetSamples samples;
    int curveIndex = 0;
    for (const Curve2d& curve : target.curves) {
        const std::vector<Eigen::Vector2d> tangents = tangentsOf(curve.pointsPx, targetTangentReach);
        samples.points.insert(samples.points.end(), curve.pointsPx.begin(), curve.pointsPx.end());
        samples.tangents.insert(samples.tangents.end(), tangents.begin(), tangents.end());
        samples.radiusPx.insert(samples.radiusPx.end(), curve.radiusPx.begin(), curve.radiusPx.end());
        samples.radiusPx.resize(samples.points.size(), 0.0);
        samples.curveIndex.insert(samples.curveIndex.end(), curve.pointsPx.size(), curveIndex++);
    }
    return samples;
}

std::optional<Message> findUnknownBranch(const VesselTree& tree, const std::vector<int>& branchIds,
                                         const MessageKind<0>& role)
{
    for (const int id : branchIds) {
        if (tree.find(id) == nullptr) {
            return messages::selectedBranchMissing(id, role());
        }
    }
    return {};
}

/// Whether vessel points lie behind the source, as they do with the identity, which is the default initial pose.
bool reachesBehindSource(const VesselTree& tree, const RigidTransform& cameraFromPatient)
{
    for (const VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            if (!((cameraFromPatient * point).z() >= minProjectableDepthMm)) {
                return true;
            }
        }
    }
    return false;
}

std::optional<Message> findProblem(const RegistrationInput& input, const VesselTree& usedTree)
{
    std::optional<Message> problem = findProblem(input.tree);
    if (!problem) {
        problem = findProblem(input.target);
    }
    if (!problem) {
        problem = findProblem(input.camera);
    }
    if (!problem) {
        problem = findUnknownBranch(input.tree, input.auxiliaryBranchIds, messages::roleAuxiliary);
    }
    if (!problem) {
        problem = findUnknownBranch(input.tree, input.excludedBranchIds, messages::roleExcluded);
    }
    if (problem) {
        return problem;
    }
    if (usedTree.branches.empty()) {
        return messages::allBranchesExcluded();
    }
    if (input.image && (input.image->width != input.camera.width || input.image->height != input.camera.height)) {
        return messages::imageNotOfCamera();
    }
    if (!isRigid(input.initialCameraFromPatient)) {
        return messages::initialPoseNotRigid();
    }
    if (reachesBehindSource(usedTree, input.initialCameraFromPatient)) {
        return messages::initialPoseBehindSource();
    }
    return {};
}

/// Returns the free degrees of freedom. Locked shifts refer to the pivot shown to the user: the picked point or, by
/// default, the centroid of the whole tree including excluded branches.
PoseFreedom freedomOf(const RegistrationInput& input, const PoseLocks& locks, const RegistrationProblem& problem)
{
    const PoseFreedom::Frame frame{
        input.lockReference.value_or(problem.start).rotation,
        input.lockPivotInPatient.value_or(problem.wholeTreeCentroid) - problem.tree.centroid};
    return {locks, frame, aboutCentroid(problem.start, problem.tree.centroid)};
}

}   // namespace

bool TreeSamples::hasRadius() const
{
    return std::any_of(radiusMm.begin(), radiusMm.end(), [](double radius) { return radius > 0.0; });
}

Result<RegistrationProblem> makeProblem(const RegistrationInput& input, const RegistrationOptions& options)
{
    const bool usesAll = input.excludedBranchIds.empty();
    const VesselTree remaining = usesAll ? VesselTree() : withoutBranches(input.tree, input.excludedBranchIds);
    const VesselTree& tree = usesAll ? input.tree : remaining;
    if (const auto problem = findProblem(input, tree)) {
        return Error(*problem);
    }
    RegistrationProblem problem;
    problem.camera = input.camera;
    problem.cameraUncertainty = cameraUncertaintyFor(input.cameraUncertainty, options.geometry);
    problem.start = {nearestRotation(input.initialCameraFromPatient.rotation),
                     input.initialCameraFromPatient.translation};
    const bool isEven = options.resample;
    problem.tree = samplesOf(isEven ? resampled(tree, options.pointSpacingMm) : tree);
    problem.wholeTreeCentroid = centroidInPatient(input.tree);
    markNodes(tree, problem.tree);
    const std::optional<ReorderedCurves> reordered = reorderCurves(input.target);
    const Centerline2d& target = reordered ? reordered->curves : input.target;
    if (reordered) {
        problem.notes.push_back(
            messages::targetReordered(static_cast<int>(reordered->reorderedPoints)).as(Severity::Note));
    }
    problem.target = sampleTarget(target, options);
    problem.freedom = freedomOf(input, options.locks, problem);
    problem.auxiliary = auxiliaryPoints(problem.tree, input.auxiliaryBranchIds, options);
    problem.hasUserAuxiliary = !input.auxiliaryBranchIds.empty();
    problem.image = input.image;
    problem.polarity = input.polarity;
    problem.shutter = input.shutter;
    problem.volume = input.volume;
    problem.tableAngles = input.tableAngles;
    return problem;
}

RegistrationProblem restrictProblem(const RegistrationProblem& whole, const std::vector<std::uint8_t>& isKept)
{
    RegistrationProblem part = whole;
    part.tree = TreeSamples();
    part.tree.branchIds = whole.tree.branchIds;
    part.tree.centroid = whole.tree.centroid;
    part.tree.spreadMm = whole.tree.spreadMm;
    std::vector<int> numberInPart(whole.tree.size(), -1);
    for (std::size_t i = 0; i < whole.tree.size(); ++i) {
        if (isKept[i] != 0) {
            numberInPart[i] = static_cast<int>(part.tree.size());
            part.tree.points.push_back(whole.tree.points[i]);
            part.tree.tangents.push_back(whole.tree.tangents[i]);
            part.tree.radiusMm.push_back(whole.tree.radiusMm[i]);
            part.tree.branchIndex.push_back(whole.tree.branchIndex[i]);
            part.tree.isNode.push_back(whole.tree.isNode[i]);
        }
    }
    part.auxiliary.clear();
    for (const int number : whole.auxiliary) {
        if (numberInPart[static_cast<std::size_t>(number)] >= 0) {
            part.auxiliary.push_back(numberInPart[static_cast<std::size_t>(number)]);
        }
    }
    part.hasUserAuxiliary = whole.hasUserAuxiliary && !part.auxiliary.empty();
    return part;
}

CameraUncertainty cameraUncertaintyFor(const CameraUncertainty& byOrigin, const GeometryOptions& options)
{
    switch (options.spread) {
        case GeometrySpread::Given:
            return {0.01 * options.focalPercent, options.principalPx, byOrigin.appliedError};
        case GeometrySpread::None:
            return {};
        case GeometrySpread::ByOrigin:
            break;
    }
    return byOrigin;
}

TargetSamples sampleTarget(const Centerline2d& target, const RegistrationOptions& options)
{
    return samplesOf(options.resample ? resampled(target, options.targetSpacingPx) : target);
}

}   // namespace angiopose::core
