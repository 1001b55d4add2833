#include "core/registration/judging/branch_information.h"

#include "core/support/symmetric.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

// The noise of neighboring traced points has correlation exp(-1/10); the variance of a mean is therefore 20 times that
// of independent points.
constexpr double unitVariancePx2 = 20.0;
constexpr double worthwhileGain = 0.05;

bool isInside(const ProjectionCamera& camera, const Eigen::Vector2d& pixel)
{
    return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() <= camera.width - 0.5 &&
           pixel.y() <= camera.height - 0.5;
}

/// Returns the length of a line segment in px if both ends are inside the image, otherwise 0.
double visibleLengthPx(const ProjectionCamera& camera, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
    const auto fromPx = project(camera, from);
    const auto toPx = project(camera, to);
    const bool isVisible = fromPx && toPx && isInside(camera, *fromPx) && isInside(camera, *toPx);
    return isVisible ? (*toPx - *fromPx).norm() : 0.0;
}

Matrix6d priorInformation(const Vector6d& priorStd)
{
    return priorStd.cwiseAbs2().cwiseInverse().asDiagonal();
}

Vector6d stdOf(const Matrix6d& information)
{
    return inverseOf(information).diagonal().cwiseSqrt();
}

Matrix6d sumOf(const std::vector<BranchInformation>& branches)
{
    Matrix6d sum = Matrix6d::Zero();
    for (const BranchInformation& branch : branches) {
        sum += branch.information;
    }
    return sum;
}

/// Returns the highest-scoring visible branch that is not in `chosen`, or null.
template <class Score>
const BranchInformation* best(const std::vector<BranchInformation>& branches, const std::vector<int>& chosen,
                              const Score& score)
{
    const BranchInformation* found = nullptr;
    double highest = -std::numeric_limits<double>::infinity();
    for (const BranchInformation& branch : branches) {
        const bool isFree = branch.lengthPx > 0.0 && std::ranges::find(chosen, branch.branchId) == chosen.end();
        if (const double value = isFree ? score(branch) : -std::numeric_limits<double>::infinity(); value > highest) {
            highest = value;
            found = &branch;
        }
    }
    return found;
}

}   // namespace

Matrix6d segmentInformation(const ProjectionCamera& camera, const Eigen::Vector3d& fromInCamera,
                            const Eigen::Vector3d& toInCamera, const Eigen::Vector3d& centerInCamera)
{
    const auto fromPx = project(camera, fromInCamera);
    const auto toPx = project(camera, toInCamera);
    const Eigen::Vector2d along = fromPx && toPx ? Eigen::Vector2d(*toPx - *fromPx) : Eigen::Vector2d::Zero();
    const double lengthPx = along.norm();   // equals the number of traced points, one per px
    if (lengthPx < 1e-9) {
        return Matrix6d::Zero();
    }
    const Eigen::Vector2d normal = Eigen::Vector2d(-along.y(), along.x()) / lengthPx;
    const Eigen::Vector3d middle = 0.5 * (fromInCamera + toInCamera);
    Eigen::Matrix<double, 3, 6> motion;
    motion << -skew(middle - centerInCamera), Eigen::Matrix3d::Identity();
    const Vector6d row = (projectionJacobian(camera, middle) * motion).transpose() * normal;
    return lengthPx * row * row.transpose();
}

std::vector<BranchInformation> branchInformation(const VesselTree& tree, const ProjectionCamera& camera,
                                                 const RigidTransform& cameraFromPatient)
{
    std::vector<BranchInformation> branches;
    const Eigen::Vector3d center = cameraFromPatient * centroidInPatient(tree);
    for (const VesselBranch& branch : tree.branches) {
        BranchInformation reported{branch.id, 0.0, Matrix6d::Zero()};
        for (std::size_t i = 1; i < branch.pointsInPatient.size(); ++i) {
            const Eigen::Vector3d from = cameraFromPatient * branch.pointsInPatient[i - 1];
            const Eigen::Vector3d to = cameraFromPatient * branch.pointsInPatient[i];
            if (const double lengthPx = visibleLengthPx(camera, from, to); lengthPx > 0.0) {
                reported.lengthPx += lengthPx;
                reported.information += segmentInformation(camera, from, to, center) / unitVariancePx2;
            }
        }
        branches.push_back(reported);
    }
    return branches;
}

Vector6d expectedStd(const std::vector<BranchInformation>& branches, const std::vector<int>& ids,
                     const Vector6d& priorStd)
{
    Matrix6d information = priorInformation(priorStd);
    for (const BranchInformation& branch : branches) {
        if (std::ranges::find(ids, branch.branchId) != ids.end()) {
            information += branch.information;
        }
    }
    return stdOf(information);
}

std::vector<int> bestBranchesForComponent(const std::vector<BranchInformation>& branches, int step,
                                          const Vector6d& priorStd, int count)
{
    std::vector<int> chosen;
    Matrix6d known = priorInformation(priorStd);
    while (static_cast<int>(chosen.size()) < count) {
        const BranchInformation* next = best(branches, chosen, [&](const BranchInformation& branch) {
            return -stdOf(known + branch.information)[step];
        });
        if (!next || stdOf(known + next->information)[step] > (1.0 - worthwhileGain) * stdOf(known)[step]) {
            break;
        }
        known += next->information;
        chosen.push_back(next->branchId);
    }
    return chosen;
}

std::vector<int> informativeBranchSet(const std::vector<BranchInformation>& branches, const Vector6d& priorStd,
                                      double tolerance)
{
    Matrix6d known = priorInformation(priorStd);
    const Vector6d wanted = tolerance * stdOf(known + sumOf(branches));
    // Radians and millimeters differ in magnitude; scaling by the prior keeps the determinants in range.
    const Matrix6d scale = priorStd.asDiagonal();
    std::vector<int> chosen;
    while ((stdOf(known).array() > wanted.array()).any()) {
        const BranchInformation* next = best(branches, chosen, [&](const BranchInformation& branch) {
            return std::log((scale * (known + branch.information) * scale).determinant());
        });
        if (!next) {
            break;
        }
        known += next->information;
        chosen.push_back(next->branchId);
    }
    return chosen;
}

}   // namespace angiopose::core
