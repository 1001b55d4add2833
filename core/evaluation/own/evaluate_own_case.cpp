#include "core/evaluation/own/evaluate_own_case.h"

#include "core/evaluation/trial/run_record.h"
#include "core/registration/deformable/deformed_tree.h"
#include "core/support/quantile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace angiopose::core {
namespace {

constexpr double grossPx = 5.0;

double meanOf(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Returns the distances in px from the projected points to their pixels; infinite for points behind the source.
std::vector<double> pixelDistances(const OwnCase& own, const RigidTransform& pose)
{
    std::vector<double> distances;
    for (const PointPair& pair : own.truth.pairs) {
        const auto found = project(own.camera, pose * pair.pointInPatient);
        distances.push_back(found ? (*found - pair.pixel).norm() : std::numeric_limits<double>::infinity());
    }
    return distances;
}

/// Returns the mean distance in mm from the points to the rays through their pixels.
double meanRayDistanceMm(const OwnCase& own, const RigidTransform& pose)
{
    std::vector<double> distances;
    for (const PointPair& pair : own.truth.pairs) {
        const Eigen::Vector3d point = pose * pair.pointInPatient;
        const Eigen::Vector3d ray = rayThroughPixel(own.camera, pair.pixel);
        distances.push_back((point - point.dot(ray) * ray).norm());
    }
    return meanOf(distances);
}

double meanDepthMm(const OwnCase& own, const RigidTransform& pose)
{
    std::vector<double> depths;
    for (const PointPair& pair : own.truth.pairs) {
        depths.push_back((pose * pair.pointInPatient).z());
    }
    return meanOf(depths);
}

void measurePairs(const OwnCase& own, const RigidTransform& pose, RunRecord& record)
{
    const std::vector<double> distances = pixelDistances(own, pose);
    const std::vector<double> shares = quantiles(distances, {0.5, 0.75, 0.95});
    record.meanPx = meanOf(distances);
    record.medianPx = shares[0];
    record.p75Px = shares[1];
    record.p95Px = shares[2];
    record.rmsPx = std::sqrt(std::inner_product(distances.begin(), distances.end(), distances.begin(), 0.0) /
                             static_cast<double>(distances.size()));
    record.meanMm = record.meanPx * millimetersPerPixel(own.camera, meanDepthMm(own, pose));
    const auto above = std::ranges::count_if(distances, [](double d) { return !(d <= grossPx); });
    record.fractionAbove5Px = static_cast<double>(above) / static_cast<double>(distances.size());
    record.mrpdMm = meanRayDistanceMm(own, pose);
}

GroundTruth groundTruthOf(const OwnCase& own)
{
    return {own.tree, own.camera, *own.truth.cameraFromPatient,
            own.truth.landmarksInPatient.empty() ? targetsOf(own.tree) : own.truth.landmarksInPatient,
            own.truth.deformedTree.get()};
}

/// Returns the tree of the result, deformed if a deformation was found.
VesselTree resultTree(const OwnCase& own, const RegistrationResult& result)
{
    const bool isShown = result.deformed && isDeformed(*result.deformed) && isCompatible(own.tree, *result.deformed);
    return isShown ? deformedTreeAt(own.tree, *result.deformed, result.cameraFromPatient) : own.tree;
}

void measureErrors(const OwnCase& own, const RigidTransform& pose, const VesselTree& shown, RunRecord& record)
{
    if (own.truth.cameraFromPatient) {
        measureInitialPose(groundTruthOf(own), own.startCameraFromPatient, record);
        measureDeformed(groundTruthOf(own), pose, shown, record);
    } else {
        record.startMeanPx = meanOf(pixelDistances(own, own.startCameraFromPatient));
        measurePairs(own, pose, record);
    }
}

}   // namespace

bool isGroundTruthFor(const VesselTree& deformed, const VesselTree& tree)
{
    return std::ranges::equal(deformed.branches, tree.branches, [](const VesselBranch& a, const VesselBranch& b) {
        return a.id == b.id && a.pointsInPatient.size() == b.pointsInPatient.size();
    });
}

RunRecord evaluateOwnCase(const OwnCase& own, const std::optional<RegistrationResult>& result)
{
    RunRecord record;
    measureErrors(own, result ? result->cameraFromPatient : own.startCameraFromPatient,
                  result ? resultTree(own, *result) : own.tree, record);
    if (result) {
        recordResult(*result, record);
        if (own.truth.cameraFromPatient) {
            measureCovariance(groundTruthOf(own), *result, record);
        }
    }
    return record;
}

RunRecord evaluateOwnCase(const OwnCase& own, const RigidTransform& found)
{
    RunRecord record;
    measureErrors(own, found, own.tree, record);
    record.hasResult = 1.0;
    record.trustworthy = unknownMeasure;
    return record;
}

}   // namespace angiopose::core
