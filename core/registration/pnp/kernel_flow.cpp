#include "core/registration/pnp/kernel_flow.h"

#include "core/registration/pnp/sample_strides.h"

#include <cmath>

namespace angiopose::core {
namespace {

constexpr double minKernel = 6e-4;   // as in the published method; pairs with a smaller kernel value are ignored
constexpr double flowReachInScales = 3.8517;   // resulting cutoff distance, √(−2 ln 6e-4)
constexpr double flowSamplesPerScale = 4.0;
constexpr double endOnInFlow = 1e-3;   // minimum projected length relative to a vessel perpendicular to the ray

}   // namespace

KernelFlow::KernelFlow(const RegistrationProblem& problem, const FlowOptions& options)
    : options_(options), camera_(problem.camera)
{
    const double wantedPx = options.scalePx / flowSamplesPerScale;
    const std::size_t everyPoint = treeStride(problem, wantedPx);
    for (std::size_t i = 0; i < problem.tree.size(); i += everyPoint) {
        samples_.push_back({problem.tree.points[i] - problem.tree.centroid, problem.tree.tangents[i]});
    }
    const std::size_t everyTarget = targetStride(problem.target, wantedPx);
    for (std::size_t j = 0; j < problem.target.size(); j += everyTarget) {
        positions_.push_back(problem.target.points[j]);
        directions_.push_back(problem.target.tangents[j]);
    }
    grid_.fill(positions_, flowReachInScales * options.scalePx);
}

void KernelFlow::projectSamples(const CentroidPose& pose)
{
    projectedSamples_.clear();
    for (const Sample& sample : samples_) {
        ProjectedSample seen;
        seen.arm = pose.rotation * sample.fromCentroid;
        seen.inCamera = seen.arm + pose.centroidInCamera;
        const auto pixel = project(camera_, seen.inCamera);
        if (!pixel) {
            continue;
        }
        seen.pixel = *pixel;
        seen.direction = projectionJacobian(camera_, seen.inCamera) * (pose.rotation * sample.tangent);
        const double length = seen.direction.norm();
        if (length > endOnInFlow * std::abs(camera_.fx) / seen.inCamera.z()) {
            seen.direction /= length;
        } else {
            seen.direction.setZero();
        }
        projectedSamples_.push_back(seen);
    }
}

/// Returns the squared cosine instead of the color product of the published method; opposite directions count as equal.
double KernelFlow::labelOf(const ProjectedSample& seen, std::size_t target) const
{
    if (!options_.directions || seen.direction.isZero()) {
        return 1.0;
    }
    const double cosine = seen.direction.dot(directions_[target]);
    return cosine * cosine;
}

KernelFlow::ValueAndGradient KernelFlow::at(const CentroidPose& pose)
{
    projectSamples(pose);
    pairs_.clear();
    ValueAndGradient slope;
    const double perSquare = 1.0 / (options_.scalePx * options_.scalePx);
    for (std::size_t i = 0; i < projectedSamples_.size(); ++i) {
        const ProjectedSample& seen = projectedSamples_[i];
        Eigen::Vector2d byPixel = Eigen::Vector2d::Zero();
        grid_.visitNear(seen.pixel, [&](std::size_t j) {
            const Eigen::Vector2d gap = seen.pixel - positions_[j];
            const double kernel = std::exp(-0.5 * perSquare * gap.squaredNorm());
            if (kernel < minKernel) {
                return;
            }
            const double label = labelOf(seen, j);
            pairs_.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), label});
            slope.value += label * kernel;
            byPixel -= label * kernel * perSquare * gap;
        });
        const Eigen::Vector3d byPoint = projectionJacobian(camera_, seen.inCamera).transpose() * byPixel;
        slope.gradient.head<3>() += seen.arm.cross(byPoint);
        slope.gradient.tail<3>() += byPoint;
    }
    const auto count = static_cast<double>(samples_.size());
    return {slope.value / count, slope.gradient / count};
}

PowerSeries KernelFlow::along(const Vector6d& step) const
{
    const Eigen::Vector3d turn = step.head<3>();
    const double perSquare = 1.0 / (options_.scalePx * options_.scalePx);
    PowerSeries sum;
    PowerSeries u;
    PowerSeries v;
    std::int32_t projected = -1;
    for (const Pair& pair : pairs_) {
        if (pair.seen != projected) {   // pairs are grouped by tree sample
            projected = pair.seen;
            const ProjectedSample& seen = projectedSamples_[static_cast<std::size_t>(projected)];
            std::array<PowerSeries, 3> place;
            Eigen::Vector3d term = seen.arm;   // exp(sω^) arm = Σ (ω^)ᵏ arm sᵏ / k!
            for (std::size_t k = 0; k < PowerSeries::terms; ++k) {
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    place[axis].at[k] = term(static_cast<Eigen::Index>(axis));
                }
                term = turn.cross(term) / static_cast<double>(k + 1);
            }
            for (std::size_t axis = 0; axis < 3; ++axis) {
                place[axis].at[0] = seen.inCamera(static_cast<Eigen::Index>(axis));
                place[axis].at[1] += step(static_cast<Eigen::Index>(axis) + 3);
            }
            u = camera_.fx * (place[0] / place[2]);
            v = camera_.fy * (place[1] / place[2]);
        }
        const Eigen::Vector2d& target = positions_[static_cast<std::size_t>(pair.target)];
        PowerSeries du = u;
        PowerSeries dv = v;
        du.at[0] += camera_.cx - target.x();
        dv.at[0] += camera_.cy - target.y();
        PowerSeries squared = du * du;
        squared += dv * dv;
        sum += pair.label * exp(-0.5 * perSquare * squared);
    }
    return 1.0 / static_cast<double>(samples_.size()) * sum;
}

}   // namespace angiopose::core
