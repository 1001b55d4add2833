#include "core/registration/deformable/deformed_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace angiopose::core {
namespace {

double toMicrometers(double mm)
{
    return std::round(1e3 * mm) / 1e3;
}

double toThreeDigits(double value)
{
    if (value == 0.0 || !std::isfinite(value)) {
        return value;
    }
    const double scale = std::pow(10.0, std::max(0.0, 2.0 - std::floor(std::log10(std::abs(value)))));
    return std::round(scale * value) / scale;
}

}   // namespace

bool isDeformed(const DeformableResult& result)
{
    return result.verdict != DeformationVerdict::Rigid && result.stopReason != StopReason::StoppedByUser;
}

const BranchMotion* findMotion(const DeformableResult& result, int branchId)
{
    const auto found = std::ranges::find(result.branches, branchId, &BranchMotion::branchId);
    return found == result.branches.end() ? nullptr : &*found;
}

bool isCompatible(const VesselTree& tree, const DeformableResult& result)
{
    return tree.branches.size() == result.branches.size() &&
           std::ranges::all_of(tree.branches, [&result](const VesselBranch& branch) {
               const BranchMotion* motion = findMotion(result, branch.id);
               const std::size_t count = branch.pointsInPatient.size();
               return motion && motion->displacementMm.size() == count && motion->covariance.size() == count;
           });
}

VesselTree deformedTree(const VesselTree& tree, const DeformableResult& result)
{
    if (!isCompatible(tree, result)) {
        return {};
    }
    VesselTree deformed = tree;
    for (VesselBranch& branch : deformed.branches) {
        const std::vector<Eigen::Vector3d>& moved = findMotion(result, branch.id)->displacementMm;
        for (std::size_t i = 0; i < moved.size(); ++i) {
            branch.pointsInPatient[i] += moved[i];
        }
    }
    return deformed;
}

VesselTree deformedTreeAt(const VesselTree& tree, const DeformableResult& result,
                          const RigidTransform& cameraFromPatient)
{
    const RigidTransform carried = cameraFromPatient.inverse() * result.cameraFromPatient;
    VesselTree deformed = deformedTree(tree, result);
    for (VesselBranch& branch : deformed.branches) {
        for (Eigen::Vector3d& point : branch.pointsInPatient) {
            point = carried * point;
        }
    }
    return deformed;
}

std::vector<double> pointDistances(const VesselBranch& branch, const VesselBranch& other,
                                   const RigidTransform& cameraFromPatient, std::size_t viewCount)
{
    std::vector<double> apartMm;
    for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
        const Eigen::Vector3d apart =
            cameraFromPatient.rotation * (other.pointsInPatient[i] - branch.pointsInPatient[i]);
        const Eigen::Vector3d ray = (cameraFromPatient * branch.pointsInPatient[i]).normalized();
        apartMm.push_back(viewCount == 1 ? apart.cross(ray).norm() : apart.norm());
    }
    return apartMm;
}

DeformableResult withViewFirst(DeformableResult result, std::size_t view)
{
    if (view == 0) {
        return result;
    }
    const Eigen::Matrix3d turn = result.viewPoses[view].rotation * result.cameraFromPatient.rotation.transpose();
    Matrix6d turnBoth = Matrix6d::Zero();
    turnBoth.topLeftCorner<3, 3>() = turn;
    turnBoth.bottomRightCorner<3, 3>() = turn;
    result.rigid.step = turnBoth * result.rigid.step;
    result.rigid.covariance = turnBoth * result.rigid.covariance * turnBoth.transpose();
    for (BranchMotion& branch : result.branches) {
        for (Eigen::Matrix3d& covariance : branch.covariance) {
            covariance = turn * covariance * turn.transpose();
        }
        roundMotion(branch);
    }
    const auto first = result.viewPoses.begin();
    std::rotate(first, first + static_cast<std::ptrdiff_t>(view), first + static_cast<std::ptrdiff_t>(view) + 1);
    result.cameraFromPatient = result.viewPoses.front();
    return result;
}

void roundMotion(BranchMotion& motion)
{
    for (Eigen::Vector3d& moved : motion.displacementMm) {
        moved = moved.unaryExpr([](double mm) { return toMicrometers(mm); });
    }
    for (Eigen::Matrix3d& covariance : motion.covariance) {
        for (int row = 0; row < 3; ++row) {
            for (int column = row; column < 3; ++column) {
                covariance(row, column) = covariance(column, row) = toThreeDigits(covariance(row, column));
            }
        }
    }
}

}   // namespace angiopose::core
