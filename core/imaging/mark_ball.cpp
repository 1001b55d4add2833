#include "core/imaging/mark_ball.h"

namespace angiopose::core {

void markBall(const Eigen::Vector3d& pointInPatient, double radiusMm, VoxelMask& mask)
{
    const VolumeGeometry& geometry = mask.geometry;
    const Eigen::Affine3d voxelFromPatient = geometry.patientFromVoxel().inverse();
    const Eigen::Vector3d center = voxelFromPatient * pointInPatient;
    const Eigen::Vector3d reach = geometry.spacingMm.cwiseInverse() * radiusMm;
    const Eigen::Vector3i low = (center - reach).array().ceil().cast<int>().max(0);
    const Eigen::Vector3i high = (center + reach).array().floor().cast<int>().min(geometry.size.array() - 1);
    for (int k = low.z(); k <= high.z(); ++k) {
        for (int j = low.y(); j <= high.y(); ++j) {
            for (int i = low.x(); i <= high.x(); ++i) {
                const Eigen::Vector3d offsetMm = geometry.spacingMm.cwiseProduct(Eigen::Vector3d(i, j, k) - center);
                if (offsetMm.squaredNorm() <= radiusMm * radiusMm) {
                    mask.at(i, j, k) = 1;
                }
            }
        }
    }
}

}   // namespace angiopose::core
