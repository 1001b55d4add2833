#include "core/registration/methods/methods.h"

#include "core/registration/methods/pose_trials.h"
#include "core/registration/picture/vessel_image.h"
#include "core/registration/picture/wall_sites.h"
#include "core/registration/pnp/pair_fit.h"
#include "core/support/random.h"
#include "core/support/stopwatch.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double blurPx = 1.0;
constexpr double stepMm = 0.25;
constexpr double reachDecay = 0.7;
constexpr double shortestReachMm = 1.0;
constexpr double settledGradientMm = 0.01;
constexpr std::size_t maxSites = 5000;
constexpr std::size_t scoringSites = 600;
constexpr double gradientDepthStdMm = 30.0;   // 1-σ of the depth prior; one view does not determine the depth
constexpr double lateralStdMm = 30.0;
constexpr double rotationStd = 0.15;   // rad
constexpr double pairStdMm = 1.0;
constexpr int fitSteps = 3;

/// A point on a vessel wall, and the image edge found for it.
using Correspondence = PointPixelPair;

class Rgbr {
public:
    Rgbr(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress)
        : options_(options),
          freedom_(problem.freedom),
          spreadMm_(problem.tree.spreadMm),
          gradients_(vesselImage(problem), problem.camera, blurPx),
          sites_(wallSites(problem.tree, maxSites)),
          fewSites_(wallSites(problem.tree, scoringSites)),
          random_(static_cast<std::uint64_t>(options.randomSeed)),
          search_(problem, options.rgbr.rounds * (1 + options.rgbr.hypotheses), progress)
    {
    }

    MethodSolution run();

private:
    std::vector<Correspondence> findEdges(const CentroidPose& pose, double reachMm) const;
    CentroidPose chooseByRansac(const std::vector<Correspondence>& pairs, const CentroidPose& from, double reachMm);
    CentroidPose fit(std::span<const Correspondence> pairs, const CentroidPose& from) const;
    double distanceMm(const Correspondence& pair, const CentroidPose& pose) const;

    const RegistrationOptions& options_;
    const PoseFreedom& freedom_;
    double spreadMm_;
    BackprojectedGradients gradients_;
    std::vector<WallSite> sites_;
    std::vector<WallSite> fewSites_;
    CounterRandom random_;
    PoseTrials search_;
};

MethodSolution Rgbr::run()
{
    StopReason reason = StopReason::IterationLimit;
    CentroidPose pose = search_.start();
    search_.startStage("walls", 0.0, -gradients_.score(sites_, pose));
    double reachMm = options_.rgbr.reachMm;
    for (int round = 0; round < options_.rgbr.rounds && !search_.isStopped(); ++round) {
        const std::vector<Correspondence> pairs = findEdges(pose, reachMm);
        if (pairs.size() < 6) {
            reason = StopReason::NoImprovement;
            break;
        }
        const CentroidPose next = chooseByRansac(pairs, pose, reachMm);
        if (search_.isStopped()) {
            break;
        }
        const Vector6d motion = stepBetween(pose, next);
        pose = next;
        search_.recordTrial(pose, -gradients_.score(sites_, pose));
        const bool isShort = reachMm <= shortestReachMm;
        if (isShort && motion.tail<3>().norm() + spreadMm_ * motion.head<3>().norm() < settledGradientMm) {
            reason = StopReason::Converged;
            break;
        }
        reachMm = std::max(shortestReachMm, reachDecay * reachMm);
    }
    return search_.solution(reason);
}

/// Finds, for each wall point, the edge with the best agreement along its normal within the search range.
std::vector<Correspondence> Rgbr::findEdges(const CentroidPose& pose, double reachMm) const
{
    std::vector<Correspondence> pairs;
    const int steps = static_cast<int>(reachMm / stepMm);
    for (const WallSite& site : sites_) {
        const Eigen::Vector3d position = pose.rotation * site.position + pose.centroidInCamera;
        const Eigen::Vector3d normal = pose.rotation * site.normal;
        double best = 0.0;
        int bestStep = 0;
        for (int k = 0; k <= 2 * steps; ++k) {
            const int step = k % 2 == 0 ? -k / 2 : (k + 1) / 2;   // nearest first; in a tie the nearest wins
            const double agreement = gradients_.agreement(position + stepMm * step * normal, normal);
            if (agreement > best) {
                best = agreement;
                bestStep = step;
            }
        }
        if (best > 0.0) {
            pairs.push_back({site.position, *project(gradients_.camera(), position + stepMm * bestStep * normal)});
        }
    }
    return pairs;
}

/// Fits poses to three random pairs each, ranks them by the gradient score of all walls instead of by inliers, and
/// refines the best pose with its inliers.
CentroidPose Rgbr::chooseByRansac(const std::vector<Correspondence>& pairs, const CentroidPose& from, double reachMm)
{
    const auto inliersOf = [&](const CentroidPose& pose) {
        std::vector<Correspondence> inliers;
        std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(inliers),
                     [&](const Correspondence& pair) { return distanceMm(pair, pose) < 0.5 * reachMm; });
        return inliers;
    };
    CentroidPose best = from;
    double bestScore = gradients_.score(fewSites_, from);
    for (int h = 0; h < options_.rgbr.hypotheses && !search_.isStopped(); ++h) {
        search_.advanceProgress();
        std::array<Correspondence, 3> three;
        for (Correspondence& pair : three) {
            pair = pairs[static_cast<std::size_t>(random_.index(static_cast<int>(pairs.size())))];
        }
        const double area = (three[1].position - three[0].position).cross(three[2].position - three[0].position).norm();
        if (area < 0.25 * spreadMm_ * spreadMm_) {
            continue;   // pairs too close together or collinear
        }
        const CentroidPose pose = fit(three, from);
        const double score = gradients_.score(fewSites_, pose);
        if (score > bestScore) {
            best = pose;
            bestScore = score;
        }
    }
    const std::vector<Correspondence> inliers = inliersOf(best);
    const CentroidPose refined = inliers.size() < 6 ? best : fit(inliers, best);
    return gradients_.score(fewSites_, refined) >= bestScore ? refined : best;
}

/// Minimizes the distances to the rays through the edges, with a prior around `from` for the parameters that one view
/// does not determine.
CentroidPose Rgbr::fit(std::span<const Correspondence> pairs, const CentroidPose& from) const
{
    Vector6d std;
    std << rotationStd, rotationStd, rotationStd, lateralStdMm, lateralStdMm, gradientDepthStdMm;
    const InitialPosePrior prior = independentPrior(from, std, freedom_);
    return fitPairs(pairs, gradients_.camera(), prior, pairStdMm, fitSteps, from);
}

double Rgbr::distanceMm(const Correspondence& pair, const CentroidPose& pose) const
{
    const Eigen::Vector3d position = pose.rotation * pair.position + pose.centroidInCamera;
    const auto pixel = project(gradients_.camera(), position);
    return pixel ? (*pixel - pair.pixel).norm() * millimetersPerPixel(gradients_.camera(), position.z())
                 : std::numeric_limits<double>::infinity();
}

}   // namespace

MethodSolution solveRgbr(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress)
{
    Stopwatch stopwatch;
    Rgbr rgbr(problem, options, progress);
    const double targetMs = stopwatch.takeLapMs();
    MethodSolution solution = rgbr.run();
    solution.time.targetMs = targetMs;
    solution.time.solveMs = stopwatch.takeLapMs();
    return solution;
}

}   // namespace angiopose::core
