#include "core/registration/pnp/seed_problem.h"

#include "core/registration/matching/feature_map.h"
#include "core/registration/matching/grid_index.h"
#include "core/registration/matching/kd_tree_index.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double depthGuardMm = 100.0;
constexpr double minSpreadShare = 0.3;
constexpr std::size_t minAuxiliaryPoints = 4;

Eigen::Vector3d meanOf(const std::vector<Eigen::Vector3d>& points)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points) {
        sum += point;
    }
    return sum / static_cast<double>(points.size());
}

double rmsSpread(const std::vector<Eigen::Vector3d>& points)
{
    const Eigen::Vector3d mean = meanOf(points);
    double sum = 0.0;
    for (const Eigen::Vector3d& point : points) {
        sum += (point - mean).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(points.size()));
}

/// Returns the prior E_init of the preset (ALGORITHMS §2, decision 17). Averaging the data over N is equivalent to N
/// times the prior.
PosePrior priorOf(const RegistrationOptions& options, double depthMm, double pointCount)
{
    PosePrior prior;
    switch (options.seed.preset) {
        case PriorPreset::SeedSum:
            prior.strength = options.seed.priorWeight;
            break;
        case PriorPreset::SeedMean:
            prior.strength = options.seed.priorWeight * pointCount;
            break;
        case PriorPreset::SeedMetric:
            prior.strength = options.seed.priorWeight * pointCount;
            prior.weights.tail<3>().setConstant(1.0 / depthMm);
            break;
        case PriorPreset::NoPrior:
            break;
    }
    return prior;
}

std::unique_ptr<PointIndex> makeIndex(IndexKind kind, const RegistrationProblem& problem)
{
    switch (kind) {
        case IndexKind::Grid:
            return std::make_unique<GridIndex>(problem.target.points);
        case IndexKind::Map:
            return std::make_unique<FeatureMap>(problem.target.points, problem.camera.width, problem.camera.height);
        case IndexKind::KdTree:
            break;
    }
    return makeKdTreeIndex(problem.target.points);
}

}   // namespace

SeedProblem makeSeedProblem(const RegistrationProblem& problem, const RegistrationOptions& options)
{
    SeedProblem seed;
    for (const Eigen::Vector3d& point : problem.tree.points) {
        seed.points.push_back(problem.start * point);
    }
    for (const int index : problem.auxiliary) {
        seed.auxiliary.push_back(seed.points[static_cast<std::size_t>(index)]);
    }
    seed.freedom = {problem.freedom, problem.start, problem.tree.centroid};
    const double depthMm = (problem.start * problem.tree.centroid).z();
    seed.minDepthMm = std::max(0.0, depthMm - depthGuardMm);
    seed.maxDepthMm = depthMm + depthGuardMm;
    seed.prior = priorOf(options, depthMm, static_cast<double>(seed.points.size()));
    seed.schedule.maxIterations = options.maxIterations;
    seed.schedule.finalScalePx = options.finalScalePx;
    seed.schedule.startScale = options.seed.startScale;
    seed.schedule.decay = options.seed.decay;
    if (seed.prior.strength == 0.0) {
        seed.schedule.minDepthMm = seed.minDepthMm;
        seed.schedule.maxDepthMm = seed.maxDepthMm;
    }
    seed.target = makeIndex(options.seed.index, problem);
    seed.neighbors = options.seed.neighbors;
    if (seed.neighbors != Neighbors::Closest) {
        seed.search = makeNeighborSearch(problem.target.points);
    }
    return seed;
}

bool determinesPose(const std::vector<Eigen::Vector3d>& auxiliary, const std::vector<Eigen::Vector3d>& points)
{
    return auxiliary.size() >= minAuxiliaryPoints && rmsSpread(auxiliary) >= minSpreadShare * rmsSpread(points);
}

}   // namespace angiopose::core
