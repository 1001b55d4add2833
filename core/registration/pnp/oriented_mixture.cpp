#include "core/registration/pnp/oriented_mixture.h"

#include "core/registration/pnp/sample_strides.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double mixtureReachInScales = 4.2426;   // kernel cutoff: 3σ of a product of two Gaussians, 3√2 σ
constexpr double samplesPerScale = 4.0;
constexpr double minDirectionLength = 1e-3;   // relative to a vessel perpendicular to the ray

}   // namespace

OrientedMixtureMetric::OrientedMixtureMetric(const RegistrationProblem& problem, const MixtureOptions& options)
    : options_(options), camera_(problem.camera), reachPx_(mixtureReachInScales * options.scalePx)
{
    const TreeSamples& tree = problem.tree;
    const double wantedPx = options.scalePx / samplesPerScale;
    const std::size_t stride = treeStride(problem, wantedPx);
    for (std::size_t i = 0; i < tree.size(); i += stride) {
        samples_.push_back({tree.points[i] - tree.centroid, tree.tangents[i]});
    }
    const TargetSamples& target = problem.target;
    const std::size_t everyTarget = targetStride(target, wantedPx);
    for (std::size_t j = 0; j < target.size(); j += everyTarget) {
        targetPositions_.push_back(target.points[j]);
        targetDirections_.push_back(target.tangents[j]);
    }
    targetGrid_.fill(targetPositions_, reachPx_);
}

void OrientedMixtureMetric::project(const CentroidPose& pose)
{
    projected_.clear();
    positions_.clear();
    directions_.clear();
    for (const Sample& sample : samples_) {
        const Eigen::Vector3d p = pose.rotation * sample.fromCentroid + pose.centroidInCamera;
        const auto position = core::project(camera_, p);
        const Eigen::Vector3d t = pose.rotation * sample.tangent;
        const Eigen::Vector2d direction(camera_.fx * (t.x() * p.z() - p.x() * t.z()),
                                        camera_.fy * (t.y() * p.z() - p.y() * t.z()));
        const double length = direction.norm();
        if (position && length > minDirectionLength * std::abs(camera_.fx) * p.z()) {
            projected_.push_back({p, t, length});
            positions_.push_back(*position);
            directions_.emplace_back(direction / length);
        }
    }
}

OrientedMixtureMetric::PairTerm OrientedMixtureMetric::compare(const Eigen::Vector2d& position,
                                                               const Eigen::Vector2d& direction,
                                                               const Eigen::Vector2d& otherPosition,
                                                               const Eigen::Vector2d& otherDirection) const
{
    const Eigen::Vector2d gap = position - otherPosition;
    if (gap.squaredNorm() > reachPx_ * reachPx_) {
        return {};
    }
    const double perPlace = 1.0 / (4.0 * options_.scalePx * options_.scalePx);
    const double perDirection = 1.0 / (4.0 * options_.orientation * options_.orientation);
    // Subtracts the value at the cutoff, so that the kernel is continuous there.
    const double near = std::exp(-gap.squaredNorm() * perPlace);
    const double above = near - std::exp(-reachPx_ * reachPx_ * perPlace);
    const Eigen::Vector2d alike = direction - otherDirection;
    const Eigen::Vector2d opposite = direction + otherDirection;
    const double alikeValue = std::exp(-alike.squaredNorm() * perDirection);
    const double oppositeValue = std::exp(-opposite.squaredNorm() * perDirection);
    return {above * (alikeValue + oppositeValue), -2.0 * perPlace * near * (alikeValue + oppositeValue) * gap,
            -2.0 * perDirection * above * (alikeValue * alike + oppositeValue * opposite)};
}

double OrientedMixtureMetric::distance(const CentroidPose& pose, Vector6d& gradient)
{
    gradient.setZero();
    project(pose);
    selfGrid_.fill(positions_, reachPx_);
    const auto count = static_cast<double>(samples_.size());
    const double selfFactor = options_.selfWeight / (count * count);
    const double crossFactor = -2.0 / (count * static_cast<double>(targetPositions_.size()));
    double sum = 0.0;
    for (std::size_t i = 0; i < positions_.size(); ++i) {
        PairTerm self;
        PairTerm cross;
        const auto add = [](const PairTerm& pair, PairTerm& to) {
            to.value += pair.value;
            to.positionGradient += pair.positionGradient;
            to.directionGradient += pair.directionGradient;
        };
        targetGrid_.visitNear(positions_[i], [&](std::size_t j) {
            add(compare(positions_[i], directions_[i], targetPositions_[j], targetDirections_[j]), cross);
        });
        selfGrid_.visitNear(positions_[i], [&](std::size_t j) {
            add(compare(positions_[i], directions_[i], positions_[j], directions_[j]), self);
        });
        sum += selfFactor * self.value + crossFactor * cross.value;
        // Both members of a self pair move, which doubles the derivative of the first.
        backpropagate(i, 2.0 * selfFactor * self.positionGradient + crossFactor * cross.positionGradient,
                      2.0 * selfFactor * self.directionGradient + crossFactor * cross.directionGradient, pose,
                      gradient);
    }
    return sum;
}

void OrientedMixtureMetric::backpropagate(std::size_t sample, const Eigen::Vector2d& positionGradient,
                                          const Eigen::Vector2d& directionGradient, const CentroidPose& pose,
                                          Vector6d& gradient) const
{
    const auto& [p, t, length] = projected_[sample];
    const Eigen::Vector2d& unit = directions_[sample];
    const Eigen::Vector2d byRaw = (directionGradient - unit * unit.dot(directionGradient)) / length;
    const double dx = camera_.fx * byRaw.x();
    const double dy = camera_.fy * byRaw.y();
    Eigen::Vector3d byPoint = projectionJacobian(camera_, p).transpose() * positionGradient;
    byPoint += Eigen::Vector3d(-dx * t.z(), -dy * t.z(), dx * t.x() + dy * t.y());
    const Eigen::Vector3d byTangent(dx * p.z(), dy * p.z(), -dx * p.x() - dy * p.y());
    gradient.head<3>() += (p - pose.centroidInCamera).cross(byPoint) + t.cross(byTangent);
    gradient.tail<3>() += byPoint;
}

}   // namespace angiopose::core
