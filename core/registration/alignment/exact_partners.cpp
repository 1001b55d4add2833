#include "core/registration/alignment/exact_partners.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr std::size_t usedPartnerPoints = 400;
constexpr double closeShare = 0.1;   // of the target's spacing: chance does not bring half the points so near
constexpr double exactPx = 1e-3;   // what real partners reach; sampled curves do not
constexpr int maxPartnerSteps = 8;
constexpr double settledPartnersMm = 1e-10;
constexpr double leastPartnerDamping = 1e-12;

/// Median distance between neighbours in the order given; jumps between curves are too few to matter.
double medianSpacingPx(const std::vector<Eigen::Vector2d>& points)
{
    std::vector<double> steps;
    steps.reserve(points.size());
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

ExactPartners::ExactPartners(const RegistrationProblem& problem)
    : camera_(problem.camera),
      freedom_(problem.freedom),
      target_(problem.givenTargetPoints),
      spacingPx_(medianSpacingPx(problem.givenTargetPoints))
{
    const std::size_t stride = std::max<std::size_t>(1, problem.givenTreePoints.size() / usedPartnerPoints);
    fromCentroid_.reserve(problem.givenTreePoints.size() / stride + 1);
    for (std::size_t i = 0; i < problem.givenTreePoints.size(); i += stride) {
        fromCentroid_.emplace_back(problem.givenTreePoints[i] - problem.tree.centroid);
    }
    pairs_.reserve(fromCentroid_.size());
    distances_.reserve(fromCentroid_.size());
}

void ExactPartners::match(const CentroidPose& pose)
{
    pairs_.clear();
    distances_.clear();
    std::size_t nearest = 0;
    for (const Eigen::Vector3d& point : fromCentroid_) {
        const Eigen::Vector3d turned = pose.rotation * point;
        const auto pixel = project(camera_, turned + pose.centroidInCamera);
        if (pixel && pixel->allFinite()) {
            nearest = target_.nearestIndex(*pixel, nearest);
            pairs_.push_back({turned, turned + pose.centroidInCamera, *pixel - target_.points()[nearest]});
            distances_.push_back(pairs_.back().residualPx.norm());
        }
    }
}

/// Median over all points; points that do not project count as far.
double ExactPartners::medianPx()
{
    const std::size_t middle = fromCentroid_.size() / 2;
    if (middle >= distances_.size()) {
        return std::numeric_limits<double>::infinity();
    }
    std::nth_element(distances_.begin(), distances_.begin() + static_cast<std::ptrdiff_t>(middle), distances_.end());
    return distances_[middle];
}

NormalEquations ExactPartners::equations(double scalePx) const
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

std::optional<CentroidPose> ExactPartners::refine(const CentroidPose& pose)
{
    match(pose);
    double offPx = medianPx();
    if (!(offPx < closeShare * spacingPx_)) {
        return {};
    }
    CentroidPose refined = pose;
    for (int k = 0; k < maxPartnerSteps; ++k) {
        const Vector6d step =
            freedom_.dampedStep(equations(std::max(3.0 * offPx, exactPx)), leastPartnerDamping, refined);
        refined = freedom_.moved(refined, step);
        match(refined);
        offPx = medianPx();
        if (step.tail<3>().norm() < settledPartnersMm) {
            break;
        }
    }
    return offPx < exactPx ? std::optional(refined) : std::nullopt;
}

}   // namespace angiopose::core