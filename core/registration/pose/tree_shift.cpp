#include "core/registration/pose/tree_shift.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {

TreeShift::TreeShift(const std::vector<Eigen::Vector3d>& pointsInPatient)
{
    const double count = static_cast<double>(std::max<std::size_t>(1, pointsInPatient.size()));
    for (const Eigen::Vector3d& point : pointsInPatient) {
        centroid_ += point / count;
    }
    for (const Eigen::Vector3d& point : pointsInPatient) {
        scatter_ += (point - centroid_) * (point - centroid_).transpose() / count;
    }
}

double TreeShift::rmsMm(const RigidTransform& a, const RigidTransform& b) const
{
    // Uses mean |T_b x − T_a x|² = |T_b c − T_a c|² + tr(D S Dᵀ), with D = R_b − R_a and S the scatter about c.
    const Eigen::Matrix3d turn = b.rotation - a.rotation;
    const double squared = (b * centroid_ - a * centroid_).squaredNorm() + (turn * scatter_ * turn.transpose()).trace();
    return std::sqrt(std::max(0.0, squared));
}

}   // namespace angiopose::core
