#include "core/imaging/compact_labels.h"

#include <algorithm>
#include <limits>

namespace angiopose::core {
namespace {

constexpr std::uint8_t lastRow = 255;
constexpr std::size_t labelCount = std::size_t{1} << 16U;

/// Calls `visit` for each labeled voxel with the index of its label in the list and the voxel's indices.
template <class Visit>
void forEachLabeledVoxel(const LabelVolume& image, const std::vector<std::size_t>& labelIndex, const Visit& visit)
{
    std::size_t at = 0;
    for (int k = 0; k < image.geometry.size.z(); ++k) {
        for (int j = 0; j < image.geometry.size.y(); ++j) {
            for (int i = 0; i < image.geometry.size.x(); ++i, ++at) {
                if (const std::size_t place = labelIndex[image.voxels[at]]; place > 0) {
                    visit(place - 1, Eigen::Vector3d(i, j, k), at);
                }
            }
        }
    }
}

}   // namespace

CompactLabels compactLabels(const LabelVolume& image, const std::vector<int>& labels)
{
    std::vector<std::size_t> labelIndex(labelCount, 0);   // 1 + index in the list; 0 if not listed
    for (std::size_t place = 0; place < labels.size(); ++place) {
        labelIndex[static_cast<std::size_t>(labels[place])] = place + 1;
    }
    CompactLabels result{VoxelMask(image.geometry), {}};
    std::vector<Eigen::Vector3d> means(labels.size(), Eigen::Vector3d::Zero());
    std::vector<double> counts(labels.size(), 0.0);
    forEachLabeledVoxel(image, labelIndex, [&](std::size_t place, const Eigen::Vector3d& voxel, std::size_t at) {
        result.rows.voxels[at] = static_cast<std::uint8_t>(std::min<std::size_t>(place + 1, lastRow));
        means[place] += voxel;
        counts[place] += 1.0;
    });
    for (std::size_t place = 0; place < labels.size(); ++place) {
        means[place] /= std::max(counts[place], 1.0);
    }
    const Eigen::Vector3d& spacingMm = image.geometry.spacingMm;
    std::vector<Eigen::Vector3d> nearest = means;
    std::vector<double> distances(labels.size(), std::numeric_limits<double>::infinity());
    forEachLabeledVoxel(image, labelIndex, [&](std::size_t place, const Eigen::Vector3d& voxel, std::size_t) {
        const double distance = (voxel - means[place]).cwiseProduct(spacingMm).squaredNorm();
        if (distance < distances[place]) {
            distances[place] = distance;
            nearest[place] = voxel;
        }
    });
    for (const Eigen::Vector3d& voxel : nearest) {
        result.centersInPatient.emplace_back(image.geometry.patientFromVoxel() * voxel);
    }
    return result;
}

}   // namespace angiopose::core
