#include "io/motion_table.h"

#include "core/registration/deformable/deformed_tree.h"
#include "io/support/atomic_file.h"
#include "io/support/numbers.h"

#include <cmath>

namespace angiopose::io {
namespace {

void addRow(const core::VesselBranch& branch, const core::BranchMotion& motion, std::size_t point, std::string& table)
{
    const Eigen::Vector3d& place = branch.pointsInPatient[point];
    const Eigen::Vector3d& moved = motion.displacementMm[point];
    const Eigen::Matrix3d& covariance = motion.covariance[point];
    const double across = std::sqrt(0.5 * (covariance(0, 0) + covariance(1, 1)));   // RMS of both directions
    const double radius = branch.radiusMm.empty() ? 0.0 : branch.radiusMm[point];
    for (const double value : {place.x(), place.y(), place.z(), radius}) {
        table += toText(value) + ",";
    }
    table += std::to_string(branch.id);
    for (const double value : {moved.x(), moved.y(), moved.z(), across, std::sqrt(covariance(2, 2))}) {
        table += "," + toText(value);
    }
    table += "\n";
}

}   // namespace

core::Status writeMotion(const core::VesselTree& tree, const core::DeformableResult& deformed, const std::string& path)
{
    std::string table = "x,y,z,radius,branch,dx,dy,dz,inPlaneSigma,depthSigma\n";
    const std::vector<core::VesselBranch> none;
    for (const core::VesselBranch& branch : core::isCompatible(tree, deformed) ? tree.branches : none) {
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            addRow(branch, *core::findMotion(deformed, branch.id), i, table);
        }
    }
    return writeAtomically(path, table);
}

}   // namespace angiopose::io
