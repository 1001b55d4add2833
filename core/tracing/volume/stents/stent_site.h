#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/voxel_components.h"

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

namespace angiopose::core {

/// Struts of stents in wide vessels.
struct StentStruts {
    std::vector<VoxelComponent> pieces;
    std::function<bool(int i, int j, int k)> isBeside;   ///< near the struts and possibly lumen, not bone
};

/// Voxel data and labels of lumen components in a box around stents. Positions count from the low corner of the box.
/// The constructor arguments must outlive this object.
class StentSite {
public:
    using Label = std::uint32_t;

    /// Opacification values in a lumen component, excluding struts.
    struct OpacificationSamples {
        std::vector<double> all;
        std::vector<double> inner;   ///< values of voxels with a lumen value above 1
    };

    /// Creates a box around the stents with a margin of `aroundMm` on all sides; nothing is labeled yet.
    StentSite(const VoxelMask& lumen, const StentStruts& wires, const VoxelOpacification& opacification,
              double aroundMm);

    const VolumeGeometry& geometry() const { return labels.geometry; }
    std::uint32_t scanIndex(const Eigen::Vector3i& at) const;
    std::uint8_t lumenAt(const Eigen::Vector3i& at) const;
    double fillAt(const Eigen::Vector3i& at) const;
    bool isBesideStruts(const Eigen::Vector3i& at) const;
    bool isStrut(const Eigen::Vector3i& at) const { return wires_.at(at.x(), at.y(), at.z()) != 0; }
    Label labelAt(const Eigen::Vector3i& at) const { return labels.at(at.x(), at.y(), at.z()); }
    OpacificationSamples collectOpacification(Label label, const VoxelBox& within) const;

    template <class Visit>
    void forEachFaceNeighbor(const Eigen::Vector3i& at, const Visit& visit) const
    {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int step : {-1, 1}) {
                const Eigen::Vector3i neighbor = at + step * Eigen::Vector3i::Unit(axis);
                if (labels.geometry.contains(neighbor)) {
                    visit(neighbor);
                }
            }
        }
    }

    /// Visits the labeled voxels of the 27-neighborhood.
    template <class Visit>
    void forEachLabeledNeighbor(const Eigen::Vector3i& at, const Visit& visit) const
    {
        for (int n = 0; n < 27; ++n) {
            const Eigen::Vector3i neighbor = at + Eigen::Vector3i(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
            if (labels.geometry.contains(neighbor) && labelAt(neighbor) != 0) {
                visit(labelAt(neighbor), neighbor);
            }
        }
    }

    VoxelGrid<Label> labels;   ///< 0 if unlabeled

private:
    const VoxelMask& lumen_;
    const StentStruts& stents_;
    const VoxelOpacification& opacification_;
    VoxelBox box_;
    VoxelMask wires_;
};

}   // namespace angiopose::core
