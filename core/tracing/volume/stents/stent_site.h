#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/voxel_pieces.h"

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

namespace angiopose::core {

/// The wires of stents in wide vessels.
struct StentWires {
    std::vector<VoxelPiece> pieces;
    std::function<bool(int i, int j, int k)> isBeside;   ///< near them and may be lumen: bone is not
};

/// What is known of each voxel around stents, and the labels of pieces of lumen there. Places are counted from the low
/// corner of a box around the stents. The arguments must outlive it.
class StentSite {
public:
    using Label = std::uint32_t;

    /// Shares of blood in a piece of lumen, wires left out.
    struct Fills {
        std::vector<double> all;
        std::vector<double> inner;   ///< where the lumen is above 1
    };

    /// With `aroundMm` on all sides of the stents; nothing is labelled yet.
    StentSite(const VoxelMask& lumen, const StentWires& wires, const VoxelFill& fill, double aroundMm);

    const VolumeGeometry& geometry() const { return labels.geometry; }
    std::uint32_t inScan(const Eigen::Vector3i& at) const;
    std::uint8_t lumenAt(const Eigen::Vector3i& at) const;
    double fillAt(const Eigen::Vector3i& at) const;
    bool isBesideWires(const Eigen::Vector3i& at) const;
    bool isWire(const Eigen::Vector3i& at) const { return wires_.at(at.x(), at.y(), at.z()) != 0; }
    Label labelAt(const Eigen::Vector3i& at) const { return labels.at(at.x(), at.y(), at.z()); }
    Fills fillsOf(Label label, const VoxelBox& within) const;

    template <class Visit>
    void eachBeside(const Eigen::Vector3i& at, const Visit& visit) const
    {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int step : {-1, 1}) {
                const Eigen::Vector3i beside = at + step * Eigen::Vector3i::Unit(axis);
                if (labels.geometry.contains(beside)) {
                    visit(beside);
                }
            }
        }
    }

    /// Those of the places around that have one.
    template <class Visit>
    void eachLabelAround(const Eigen::Vector3i& at, const Visit& visit) const
    {
        for (int n = 0; n < 27; ++n) {
            const Eigen::Vector3i beside = at + Eigen::Vector3i(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
            if (labels.geometry.contains(beside) && labelAt(beside) != 0) {
                visit(labelAt(beside), beside);
            }
        }
    }

    VoxelGrid<Label> labels;   ///< 0 where there is none

private:
    const VoxelMask& lumen_;
    const StentWires& stents_;
    const VoxelFill& fill_;
    VoxelBox box_;
    VoxelMask wires_;
};

}   // namespace angiopose::core