#include "core/registration/pnp/kernel_distances.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

/// Returns one row of the image Jacobian J = Jπ [−[X]×, I] from a row a of Jπ: [X × a, a].
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

/// Adds both image rows of a pair to the normal equations.
void addPair(const ProjectionCamera& camera, const Eigen::Vector3d& pointInCamera, const Eigen::Vector2d& residualPx,
             double weight, NormalEquations& equations)
{
    const Eigen::Matrix<double, 2, 3> jacobian = projectionJacobian(camera, pointInCamera);
    addRow(poseRow(pointInCamera, jacobian.row(0).transpose()), weight, residualPx.x(), equations);
    addRow(poseRow(pointInCamera, jacobian.row(1).transpose()), weight, residualPx.y(), equations);
}

constexpr std::size_t fewNeighbors = 5;
constexpr std::size_t maxNeighbors = 64;
constexpr double radiusInScales = 3.0;

/// Finds target points other than the nearest that also attract a tree point, by the problem's rule.
class FurtherMatchSearch {
public:
    FurtherMatchSearch(const KernelProblem& problem, double scalePx)
        : search_(problem.fixedMatchesPx.empty() ? problem.search : nullptr)
    {
        const bool isRadius = problem.neighbors == Neighbors::Radius;
        count_ = isRadius ? maxNeighbors : fewNeighbors;
        radiusPx_ = isRadius ? radiusInScales * scalePx : std::numeric_limits<double>::infinity();
        if (problem.neighbors == Neighbors::Closest || radiusPx_ == 0.0) {
            search_ = nullptr;
        }
    }

    void add(std::size_t point, const Eigen::Vector2d& pixel, std::vector<FurtherMatch>& otherMatches)
    {
        if (search_ == nullptr) {
            return;
        }
        search_->find(pixel, count_, radiusPx_, foundPx_);
        for (std::size_t i = 1; i < foundPx_.size(); ++i) {   // skips the nearest, which is already included
            const Eigen::Vector2d residualPx = pixel - foundPx_[i];
            otherMatches.push_back({point, residualPx, residualPx.squaredNorm()});
        }
    }

private:
    const NeighborSearch* search_;
    std::size_t count_ = 0;
    double radiusPx_ = 0.0;
    std::vector<Eigen::Vector2d> foundPx_;
};

}   // namespace

void measureDistances(const KernelProblem& problem, const RigidTransform& pose, KernelDistances& distances,
                      double scalePx)
{
    const std::size_t count = problem.points.size();
    assert(problem.fixedMatchesPx.empty() || problem.fixedMatchesPx.size() == count);
    distances.inCamera.resize(count);
    distances.residualPx.resize(count);
    distances.squaredPx.resize(count);
    distances.otherMatches.clear();
    FurtherMatchSearch otherMatches(problem, scalePx);
    for (std::size_t i = 0; i < count; ++i) {
        distances.inCamera[i] = pose * problem.points[i];
        const auto pixel = project(problem.camera, distances.inCamera[i]);
        if (!pixel) {
            distances.residualPx[i].setZero();
            distances.squaredPx[i] = std::numeric_limits<double>::infinity();
            continue;
        }
        const Eigen::Vector2d partner =
            problem.fixedMatchesPx.empty() ? problem.target->nearest(*pixel) : problem.fixedMatchesPx[i];
        distances.residualPx[i] = *pixel - partner;
        distances.squaredPx[i] = distances.residualPx[i].squaredNorm();
        otherMatches.add(i, *pixel, distances.otherMatches);
    }
}

double kernelLoss(const KernelDistances& distances, double scalePx)
{
    const double factor = -0.5 / (scalePx * scalePx);
    double loss = 0.0;
    for (const double squared : distances.squaredPx) {
        loss -= std::expm1(factor * squared);
    }
    for (const FurtherMatch& partner : distances.otherMatches) {
        loss -= std::exp(factor * partner.squaredPx);
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
            continue;   // too far away to contribute, or behind the source
        }
        addPair(problem.camera, distances.inCamera[i], distances.residualPx[i], weight, equations);
    }
    for (const FurtherMatch& partner : distances.otherMatches) {
        const double weight = std::exp(factor * partner.squaredPx);
        if (weight >= 1e-12) {
            addPair(problem.camera, distances.inCamera[partner.point], partner.residualPx, weight, equations);
        }
    }
    return equations;
}

NormalEquations huberEquations(const KernelProblem& problem, const KernelDistances& distances, double huberPx)
{
    NormalEquations equations;
    for (std::size_t i = 0; i < distances.squaredPx.size(); ++i) {
        if (std::isfinite(distances.squaredPx[i])) {
            const double weight = std::min(1.0, huberPx / std::sqrt(std::max(distances.squaredPx[i], 1e-300)));
            addPair(problem.camera, distances.inCamera[i], distances.residualPx[i], weight, equations);
        }
    }
    return equations;
}

double huberLoss(const KernelProblem& problem, const KernelDistances& distances, double huberPx)
{
    const double lostPx = 0.5 * std::hypot(problem.camera.width, problem.camera.height);
    double loss = 0.0;
    for (const double squared : distances.squaredPx) {
        const double distancePx = std::isfinite(squared) ? std::sqrt(squared) : lostPx;
        loss += distancePx <= huberPx ? distancePx * distancePx : huberPx * (2.0 * distancePx - huberPx);
    }
    return loss;
}

double maxDistancePx(const KernelDistances& distances)
{
    double largest = 0.0;
    for (const double squared : distances.squaredPx) {
        largest = std::isfinite(squared) ? std::max(largest, squared) : largest;
    }
    return std::sqrt(largest);
}

int countWithin(const KernelDistances& distances, double radiusPx)
{
    const double limit = radiusPx * radiusPx;
    const auto near = std::count_if(distances.squaredPx.begin(), distances.squaredPx.end(),
                                    [limit](double squared) { return squared <= limit; });
    const auto otherMatches =
        std::count_if(distances.otherMatches.begin(), distances.otherMatches.end(),
                      [limit](const FurtherMatch& partner) { return partner.squaredPx <= limit; });
    return static_cast<int>(near + otherMatches);
}

double medianDistancePx(const KernelDistances& distances, std::vector<double>& scratch)
{
    scratch = distances.squaredPx;
    const auto middle = scratch.begin() + static_cast<std::ptrdiff_t>(scratch.size() / 2);
    std::nth_element(scratch.begin(), middle, scratch.end());
    return std::sqrt(*middle);
}

}   // namespace angiopose::core
