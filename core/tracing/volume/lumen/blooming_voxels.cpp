#include "core/tracing/volume/lumen/blooming_voxels.h"

#include <vector>

namespace angiopose::core {
namespace {

class BloomingDescent {
public:
    BloomingDescent(VoxelMask& flags, const BloomingBits& bits, const VoxelOpacification& opacification, double minFill)
        : flags_(flags), bits_(bits), opacification_(opacification), minFill_(minFill)
    {
        for (std::size_t voxel = 0; voxel < flags.voxels.size(); ++voxel) {
            if ((flags.voxels[voxel] & bits.bright) != 0) {
                front_.push_back(static_cast<std::uint32_t>(voxel));
            }
        }
    }

    /// Descends one step farther, along the axes for which `isOpen` is set.
    void advance(const Eigen::Array<bool, 3, 1>& isOpen)
    {
        std::vector<std::uint32_t> next;
        for (const std::uint32_t voxel : front_) {
            const Eigen::Vector3i at = flags_.geometry.voxelAt(voxel);
            const double opacification = opacification_(at.x(), at.y(), at.z());
            for (int axis = 0; axis < 3; ++axis) {
                if (isOpen[axis]) {
                    descend(at - Eigen::Vector3i::Unit(axis), opacification, next);
                    descend(at + Eigen::Vector3i::Unit(axis), opacification, next);
                }
            }
        }
        front_.swap(next);
    }

private:
    void descend(const Eigen::Vector3i& to, double fromFill, std::vector<std::uint32_t>& next)
    {
        const VolumeGeometry& grid = flags_.geometry;
        if (!grid.contains(to)) {
            return;
        }
        std::uint8_t& flag = flags_.at(to.x(), to.y(), to.z());
        if ((flag & (bits_.bright | bits_.solid | bits_.blooming)) != 0) {
            return;
        }
        const double opacification = opacification_(to.x(), to.y(), to.z());
        if (opacification >= minFill_ && opacification < fromFill) {
            flag = static_cast<std::uint8_t>(flag | bits_.blooming);
            next.push_back(static_cast<std::uint32_t>(grid.index(to.x(), to.y(), to.z())));
        }
    }

    VoxelMask& flags_;
    const BloomingBits& bits_;
    const VoxelOpacification& opacification_;
    double minFill_;
    std::vector<std::uint32_t> front_;   ///< most recently reached voxels
};

}   // namespace

void markBlooming(VoxelMask& flags, const BloomingBits& bits, const VoxelOpacification& opacification, double minFill,
                  const Eigen::Vector3i& reach, TracingProgress& progress)
{
    BloomingDescent descent(flags, bits, opacification, minFill);
    for (int step = 0; step < reach.maxCoeff() && progress.advance(0.0); ++step) {
        descent.advance(reach.array() > step);
    }
}

}   // namespace angiopose::core
