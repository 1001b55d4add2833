#include "core/tracing/volume/lumen/bright_skirts.h"

#include <vector>

namespace angiopose::core {
namespace {

class SkirtDescent {
public:
    SkirtDescent(VoxelMask& flags, const SkirtBits& bits, const VoxelFill& fill, double leastFill)
        : flags_(flags), bits_(bits), fill_(fill), leastFill_(leastFill)
    {
        for (std::size_t voxel = 0; voxel < flags.voxels.size(); ++voxel) {
            if ((flags.voxels[voxel] & bits.bright) != 0) {
                shore_.push_back(static_cast<std::uint32_t>(voxel));
            }
        }
    }

    /// One step further down along the axes that `isOpen` for it.
    void advance(const Eigen::Array<bool, 3, 1>& isOpen)
    {
        std::vector<std::uint32_t> next;
        for (const std::uint32_t voxel : shore_) {
            const Eigen::Vector3i at = flags_.geometry.voxelAt(voxel);
            const double fill = fill_(at.x(), at.y(), at.z());
            for (int axis = 0; axis < 3; ++axis) {
                if (isOpen[axis]) {
                    descend(at - Eigen::Vector3i::Unit(axis), fill, next);
                    descend(at + Eigen::Vector3i::Unit(axis), fill, next);
                }
            }
        }
        shore_.swap(next);
    }

private:
    void descend(const Eigen::Vector3i& to, double fromFill, std::vector<std::uint32_t>& next)
    {
        const VolumeGeometry& grid = flags_.geometry;
        if (!grid.contains(to)) {
            return;
        }
        std::uint8_t& flag = flags_.at(to.x(), to.y(), to.z());
        if ((flag & (bits_.bright | bits_.solid | bits_.skirt)) != 0) {
            return;
        }
        const double fill = fill_(to.x(), to.y(), to.z());
        if (fill >= leastFill_ && fill < fromFill) {
            flag = static_cast<std::uint8_t>(flag | bits_.skirt);
            next.push_back(static_cast<std::uint32_t>(grid.index(to.x(), to.y(), to.z())));
        }
    }

    VoxelMask& flags_;
    const SkirtBits& bits_;
    const VoxelFill& fill_;
    double leastFill_;
    std::vector<std::uint32_t> shore_;   ///< where the ways have come to
};

}   // namespace

void markSkirts(VoxelMask& flags, const SkirtBits& bits, const VoxelFill& fill, double leastFill,
                const Eigen::Vector3i& reach, TracingProgress& progress)
{
    SkirtDescent descent(flags, bits, fill, leastFill);
    for (int step = 0; step < reach.maxCoeff() && progress.advance(0.0); ++step) {
        descent.advance(reach.array() > step);
    }
}

}   // namespace angiopose::core