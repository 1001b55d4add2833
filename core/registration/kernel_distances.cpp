#include "core/registration/kernel_distances.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace core {
namespace {

/// One image row of J = Jπ [−[X]×, I] from a row of Jπ: [X × a, a].
Vector6d poseRow(const Eigen::Vector3d& pointInCamera, const Eigen::Vector3d& imageRow)
{
    Vector6d row;
    row << pointInCamera.cross(imageRow), imageRow;
    return row;
}

void addRow(const Vector6d& row, double weight, double residual, NormalEquations& equations)
{
    const Vector6d weighted = weight * row;
    for (int k = 0; k < 6; ++k) {
        equations.hessian.col(k).tail(6 - k) += weighted(k) * row.tail(6 - k);
    }
    equations.gradient += residual * weighted;
}

}   // namespace

void measure(const KernelProblem& problem, const RigidTransform& pose, KernelDistances& distances)
{
    const std::size_t count = problem.points.size();
    assert(problem.fixedPartnersPx.empty() || problem.fixedPartnersPx.size() == count);
    distances.inCamera.resize(count);
    distances.residualPx.resize(count);
    distances.squaredPx.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        distances.inCamera[i] = pose * problem.points[i];
        const auto pixel = project(problem.camera, distances.inCamera[i]);
        if (!pixel) {
            distances.residualPx[i].setZero();
            distances.squaredPx[i] = std::numeric_limits<double>::infinity();
            continue;
        }
        const Eigen::Vector2d partner =
            problem.fixedPartnersPx.empty() ? problem.target->nearest(*pixel) : problem.fixedPartnersPx[i];
        distances.residualPx[i] = *pixel - partner;
        distances.squaredPx[i] = distances.residualPx[i].squaredNorm();
    }
}

double kernelLoss(const KernelDistances& distances, double scalePx)
{
    const double factor = -0.5 / (scalePx * scalePx);
    double loss = 0.0;
    for (const double squared : distances.squaredPx) {
        loss -= std::expm1(factor * squared);
    }
    return loss;
}

NormalEquations kernelEquations(const KernelProblem& problem, const KernelDistances& distances, double scalePx)
{
    const double factor = -0.5 / (scalePx * scalePx);
    NormalEquations equations;
    for (std::size_t i = 0; i < distances.squaredPx.size(); ++i) {
        const double weight = std::exp(factor * distances.squaredPx[i]);
        if (weight < 1e-12) {
            continue;   // too far to pull, or behind the source
        }
        const Eigen::Vector3d& point = distances.inCamera[i];
        const Eigen::Matrix<double, 2, 3> jacobian = projectionJacobian(problem.camera, point);
        addRow(poseRow(point, jacobian.row(0).transpose()), weight, distances.residualPx[i].x(), equations);
        addRow(poseRow(point, jacobian.row(1).transpose()), weight, distances.residualPx[i].y(), equations);
    }
    return equations;
}

double largestDistancePx(const KernelDistances& distances)
{
    double largest = 0.0;
    for (const double squared : distances.squaredPx) {
        largest = std::isfinite(squared) ? std::max(largest, squared) : largest;
    }
    return std::sqrt(largest);
}

int countWithin(const KernelDistances& distances, double radiusPx)
{
    return static_cast<int>(std::count_if(distances.squaredPx.begin(), distances.squaredPx.end(),
                                          [radiusPx](double squared) { return squared <= radiusPx * radiusPx; }));
}

double medianDistancePx(const KernelDistances& distances, std::vector<double>& scratch)
{
    scratch = distances.squaredPx;
    const auto middle = scratch.begin() + static_cast<std::ptrdiff_t>(scratch.size() / 2);
    std::nth_element(scratch.begin(), middle, scratch.end());
    return std::sqrt(*middle);
}

}   // namespace core
