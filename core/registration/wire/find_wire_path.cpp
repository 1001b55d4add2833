#include "core/registration/wire/find_wire_path.h"

#include "core/registration/wire/wire_report.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double wireSpacingMm = 2.0;
constexpr std::size_t maxWirePoints = 120;
constexpr std::size_t maxKnots = 4000;
constexpr std::size_t maxTestedPaths = 40;   // number of paths tested in each of two rounds
constexpr double firstReachMm = 2.5;   // 1-σ pose error assumed when searching for paths around a shifted initial pose
constexpr double secondReachMm = 1.5;
constexpr double shiftStepMm = 4.0;   // minimum spacing of the shifted initial poses
constexpr double shiftSigmas = 2.0;   // range of the shifted initial poses, in standard deviations
constexpr int maxShiftsPerSide = 4;

/// Converts tree samples back to branches.
VesselTree treeOf(const TreeSamples& samples)
{
    VesselTree tree;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (i == 0 || samples.branchIndex[i] != samples.branchIndex[i - 1]) {
            tree.branches.push_back({samples.branchIds[static_cast<std::size_t>(samples.branchIndex[i])], {}, {}, {}});
        }
        tree.branches.back().pointsInPatient.push_back(samples.points[i]);
        tree.branches.back().radiusMm.push_back(samples.radiusMm[i]);
    }
    return tree;
}

TreeKnots knotsOf(const VesselTree& tree)
{
    double lengthMm = 0.0;
    for (const VesselBranch& branch : tree.branches) {
        lengthMm += branch.lengthMm();
    }
    return treeKnots(tree, {}, std::max(wireKnotSpacingMm, lengthMm / static_cast<double>(maxKnots)));
}

struct PosedPath {
    TreePath way;
    CentroidPose pose;
    double cost = 0.0;   ///< combined cost of path and pose
};

/// One search in progress: finds paths, fits poses to them and evaluates the fits.
class WireSearch {
public:
    WireSearch(const RegistrationProblem& problem, const RegistrationOptions& options, const WireObserver& observe)
        : problem_(problem),
          observe_(observe),
          tree_(treeOf(problem.tree)),
          knots_(knotsOf(tree_)),
          start_(aboutCentroid(problem.start, problem.tree.centroid)),
          prior_(initialPosePrior(start_, options, problem.freedom)),
          curve_(wireCurve(problem.target, wireSpacingMm / mmPerPx(), maxWirePoints)),
          reversedCurve_(reversed(curve_)),
          wire_{problem.camera, knots_, problem.tree.centroid, problem.tree.spreadMm, curve_, reversedCurve_, prior_},
          pathRank_(static_cast<std::size_t>(options.wire.way))
    {
        model_.offAxisMm = options.wire.offAxisMm;
        all_.resize(knots_.size());
        for (std::size_t k = 0; k < all_.size(); ++k) {
            all_[k] = k;
        }
    }

    WireResult find()
    {
        fitPaths(pathsNear(shiftedStarts(), firstReachMm), 0.5);
        if (!isStopped_ && !fits_.empty()) {
            fitPaths(pathsNear({fits_.front().pose}, secondReachMm), 0.9);
        }
        if (!isStopped_) {
            report(1.0);
        }
        return WireReport(problem_, tree_, wire_, model_, mmPerPx()).makeResult(fits_, pathRank_);
    }

private:
    double mmPerPx() const
    {
        return millimetersPerPixel(problem_.camera, std::max(minProjectableDepthMm, start_.centroidInCamera.z()));
    }

    bool report(double progress)
    {
        const CentroidPose& best = fits_.empty() ? start_ : fits_.front().pose;
        isStopped_ = observe_(progress, cameraFromPatient(best, problem_.tree.centroid)) == ObserverDecision::Stop;
        return !isStopped_;
    }

    /// Returns the initial pose shifted across the ray within its uncertainty.
    std::vector<CentroidPose> shiftedStarts() const
    {
        std::vector<CentroidPose> starts;
        const double reachMm = shiftSigmas * prior_.std().segment<2>(3).maxCoeff();
        const double stepMm = std::max(shiftStepMm, reachMm / maxShiftsPerSide);
        const int perSide = static_cast<int>(reachMm / stepMm);
        for (int row = -perSide; row <= perSide; ++row) {
            for (int column = -perSide; column <= perSide; ++column) {
                Vector6d step = Vector6d::Zero();
                step[3] = column * stepMm;
                step[4] = row * stepMm;
                if (step.norm() <= reachMm) {
                    starts.push_back(prior_.freedom.restoreLockedAxes(retract(start_, step)));
                }
            }
        }
        return starts;
    }

    /// Returns the most likely paths over all of these poses, each with the pose at which it was found.
    std::vector<PosedPath> pathsNear(const std::vector<CentroidPose>& poses, double reachMm)
    {
        WireModel reaching = model_;
        reaching.reachMm = reachMm;
        std::vector<PosedPath> all;
        for (const CentroidPose& pose : poses) {
            const auto paths = findLikelyPaths(knots_, wire_.projected(all_, pose), curve_, reaching, maxTestedPaths,
                                               [&] { return report(shareDone_); });
            for (const TreePath& way : paths) {
                const double cost = way.cost + 0.5 * prior_.cost(pose);
                const auto known =
                    std::ranges::find(all, way.knots, [](const PosedPath& other) { return other.way.knots; });
                if (known == all.end()) {
                    all.push_back({way, pose, cost});
                } else if (cost < known->cost) {
                    *known = {way, pose, cost};
                }
            }
            if (isStopped_) {
                break;
            }
            shareDone_ += 0.4 / static_cast<double>(poses.size());
        }
        std::ranges::stable_sort(all, {}, &PosedPath::cost);
        all.resize(std::min(all.size(), maxTestedPaths));
        return all;
    }

    void fitPaths(const std::vector<PosedPath>& paths, double shareInTheEnd)
    {
        const double from = shareDone_;
        for (std::size_t w = 0; w < paths.size() && !isStopped_; ++w) {
            fits_.push_back(fitWire(wire_, paths[w].way, paths[w].pose, model_));
            std::ranges::stable_sort(fits_, std::ranges::greater(), &WireFit::logEvidence);
            shareDone_ = from + (shareInTheEnd - from) * static_cast<double>(w + 1) / static_cast<double>(paths.size());
            report(shareDone_);
        }
    }

    const RegistrationProblem& problem_;
    const WireObserver& observe_;
    VesselTree tree_;
    TreeKnots knots_;
    CentroidPose start_;
    InitialPosePrior prior_;
    WireCurve curve_;
    WireCurve reversedCurve_;
    WireProblem wire_;
    WireModel model_;
    std::size_t pathRank_;   ///< rank of the path to use, counting from the most likely
    std::vector<std::size_t> all_;   ///< indices of all knots
    std::vector<WireFit> fits_;   ///< most likely first
    double shareDone_ = 0.0;
    bool isStopped_ = false;
};

}   // namespace

WireResult findWirePath(const RegistrationProblem& problem, const RegistrationOptions& options,
                        const WireObserver& observe)
{
    return WireSearch(problem, options, observe).find();
}

}   // namespace angiopose::core
