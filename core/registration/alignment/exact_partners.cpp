#include "core/registration/alignment/exact_partners.h"

#include "core/registration/matching/grid_index.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr std::size_t usedPoints = 400;
constexpr double closeShare = 0.1;   // of the target's spacing: chance does not bring half the points so near
constexpr double exactPx = 1e-3;   // what real partners reach; sampled curves do not
constexpr int maxSteps = 8;
constexpr double settledMm = 1e-10;
constexpr double leastDamping = 1e-12;

/// A tree point in the camera and its way to the nearest target point.
struct Pair {
    Eigen::Vector3d turned;   ///< from the centroid, camera axes
    Eigen::Vector3d inCamera;
    Eigen::Vector2d residualPx;
};

class PartnerSearch {
public:
    explicit PartnerSearch(const RegistrationProblem& problem)
        : camera_(problem.camera), target_(problem.givenTargetPoints)
    {
        const std::size_t stride = std::max<std::size_t>(1, problem.givenTreePoints.size() / usedPoints);
        for (std::size_t i = 0; i < problem.givenTreePoints.size(); i += stride) {
            fromCentroid_.push_back(problem.givenTreePoints[i] - problem.tree.centroid);
        }
    }

    void match(const CentroidPose& pose)
    {
        pairs_.clear();
        distances_.clear();
        for (const Eigen::Vector3d& point : fromCentroid_) {
            const Eigen::Vector3d turned = pose.rotation * point;
            const auto pixel = project(camera_, turned + pose.centroidInCamera);
            if (pixel && pixel->allFinite()) {
                pairs_.push_back({turned, turned + pose.centroidInCamera, *pixel - target_.nearest(*pixel)});
                distances_.push_back(pairs_.back().residualPx.norm());
            }
        }
    }

    /// Median over all points; points that do not project count as far.
    double medianPx()
    {
        const std::size_t middle = fromCentroid_.size() / 2;
        if (middle >= distances_.size()) {
            return std::numeric_limits<double>::infinity();
        }
        std::nth_element(distances_.begin(), distances_.begin() + static_cast<std::ptrdiff_t>(middle),
                         distances_.end());
        return distances_[middle];
    }

    NormalEquations equations(double scalePx) const
    {
        NormalEquations sum;
        for (const Pair& pair : pairs_) {
            const double weight = std::exp(-0.5 * pair.residualPx.squaredNorm() / (scalePx * scalePx));
            Eigen::Matrix<double, 2, 6> J;
            J.rightCols<3>() = projectionJacobian(camera_, pair.inCamera);
            J.leftCols<3>() = -J.rightCols<3>() * skew(pair.turned);
            sum.hessian += weight * J.transpose() * J;
            sum.gradient += weight * J.transpose() * pair.residualPx;
        }
        return sum;
    }

private:
    ProjectionCamera camera_;
    GridIndex target_;
    std::vector<Eigen::Vector3d> fromCentroid_;
    std::vector<Pair> pairs_;
    std::vector<double> distances_;
};

/// Median distance between neighbours in the order given; jumps between curves are too few to matter.
double medianSpacingPx(const std::vector<Eigen::Vector2d>& points)
{
    std::vector<double> steps;
    for (std::size_t i = 1; i < points.size(); ++i) {
        steps.push_back((points[i] - points[i - 1]).norm());
    }
    if (steps.empty()) {
        return 0.0;
    }
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

}   // namespace

std::optional<CentroidPose> refineWithExactPartners(const RegistrationProblem& problem, const CentroidPose& pose)
{
    PartnerSearch search(problem);
    search.match(pose);
    double medianPx = search.medianPx();
    if (!(medianPx < closeShare * medianSpacingPx(problem.givenTargetPoints))) {
        return {};
    }
    CentroidPose refined = pose;
    for (int k = 0; k < maxSteps; ++k) {
        const double scalePx = std::max(3.0 * medianPx, exactPx);
        const Vector6d step = problem.freedom.dampedStep(search.equations(scalePx), leastDamping, refined);
        refined = problem.freedom.moved(refined, step);
        search.match(refined);
        medianPx = search.medianPx();
        if (step.tail<3>().norm() < settledMm) {
            break;
        }
    }
    return medianPx < exactPx ? std::optional(refined) : std::nullopt;
}

}   // namespace core
