#include "core/registration/pnp/graph_score.h"

#include "core/geometry/projection_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace angiopose::core {
namespace {

constexpr std::size_t graphScorePoints = 200;

/// Returns the RMS distance of the target points from their mean, at least 1 px.
double spreadPxOf(const TargetSamples& target)
{
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& point : target.points) {
        mean += point / static_cast<double>(target.size());
    }
    double squares = 0.0;
    for (const Eigen::Vector2d& point : target.points) {
        squares += (point - mean).squaredNorm();
    }
    return std::max(1.0, std::sqrt(squares / static_cast<double>(target.size())));
}

}   // namespace

GraphScore::GraphScore(const RegistrationProblem& problem, double spreadWeight)
    : camera_(problem.camera),
      spreadWeight_(spreadWeight),
      target_(problem.target.points, problem.camera.width, problem.camera.height),
      targetSpreadPx_(spreadPxOf(problem.target))
{
    const std::size_t stride = std::max<std::size_t>(1, problem.tree.size() / graphScorePoints);
    for (std::size_t i = 0; i < problem.tree.size(); i += stride) {
        probes_.emplace_back(problem.tree.points[i] - problem.tree.centroid);
    }
}

/// Returns the mean of exp(−d/σ) over the tree minus λ (P/Q + Q/P) of the spreads of tree and image.
double GraphScore::scoreAt(const CentroidPose& pose) const
{
    double near = 0.0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double squares = 0.0;
    double count = 0.0;
    for (const Eigen::Vector3d& probe : probes_) {
        const auto pixel = project(camera_, pose.rotation * probe + pose.centroidInCamera);
        if (!pixel || pixel->cwiseAbs().maxCoeff() > 1e6) {
            continue;
        }
        near += std::exp(-(target_.points()[target_.lookUp(pixel->x(), pixel->y())] - *pixel).norm() / scalePx);
        sum += *pixel;
        squares += pixel->squaredNorm();
        count += 1.0;
    }
    if (count == 0.0) {
        return -std::numeric_limits<double>::infinity();
    }
    const double variance = squares / count - (sum / count).squaredNorm();
    const double ratio = std::sqrt(std::max(1.0, variance)) / targetSpreadPx_;
    return near / static_cast<double>(probes_.size()) - spreadWeight_ * (ratio + 1.0 / ratio);
}

}   // namespace angiopose::core
