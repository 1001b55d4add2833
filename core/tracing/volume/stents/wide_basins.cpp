#include "core/tracing/volume/stents/wide_basins.h"

#include <algorithm>

namespace angiopose::core {
namespace {

class BasinFlooding {
public:
    BasinFlooding(const DistanceMap& distances, double minNeck)
        : distances_(distances), minNeck_(minNeck), labels_(distances.units.size(), 0)
    {
    }

    std::vector<std::uint32_t> run()
    {
        std::vector<std::uint32_t> order;
        for (std::uint32_t voxel = 0; voxel < labels_.size(); ++voxel) {
            if (distances_.units[voxel] > 0) {
                order.push_back(voxel);
            }
        }
        std::stable_sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
            return distances_.units[a] > distances_.units[b];
        });
        for (const std::uint32_t voxel : order) {
            flood(voxel);
        }
        for (std::uint32_t& label : labels_) {
            label = label == 0 ? 0 : basinOf(label);
        }
        return std::move(labels_);
    }

private:
    struct Basin {
        std::uint32_t mergedInto = 0;   ///< basin into which this one was merged, or this one
        std::uint16_t peak = 0;
    };

    std::uint32_t basinOf(std::uint32_t label) const
    {
        while (basins_[label - 1].mergedInto != label) {
            label = basins_[label - 1].mergedInto;
        }
        return label;
    }

    std::uint16_t peakOf(std::uint32_t basin) const { return basins_[basin - 1].peak; }

    /// Assigns a voxel to the basin of its highest neighbor; merges adjacent basins if the neck is wide enough.
    void flood(std::uint32_t voxel)
    {
        std::uint32_t ownBasin = 0;
        std::uint16_t highest = 0;
        forEachNeighbor(voxel, [&](std::uint32_t neighbor, std::uint32_t basin) {
            if (distances_.units[neighbor] > highest) {
                highest = distances_.units[neighbor];
                ownBasin = basin;
            }
        });
        const std::uint16_t height = distances_.units[voxel];
        if (ownBasin == 0) {
            basins_.push_back({static_cast<std::uint32_t>(basins_.size() + 1), height});
            ownBasin = basins_.back().mergedInto;
        }
        labels_[voxel] = ownBasin;
        forEachNeighbor(voxel,
                        [&](std::uint32_t, std::uint32_t basin) { mergeIfWide(basinOf(ownBasin), basin, height); });
    }

    void mergeIfWide(std::uint32_t one, std::uint32_t other, std::uint16_t height)
    {
        const auto& [lower, higher] =
            std::minmax(one, other, [this](std::uint32_t a, std::uint32_t b) { return peakOf(a) < peakOf(b); });
        if (one != other && height >= minNeck_ * peakOf(lower)) {
            basins_[lower - 1].mergedInto = higher;
        }
    }

    template <class Visit>
    void forEachNeighbor(std::uint32_t voxel, const Visit& visit) const
    {
        const VolumeGeometry& grid = distances_.geometry;
        const Eigen::Vector3i at = grid.voxelAt(voxel);
        for (int n = 0; n < 27; ++n) {
            const Eigen::Vector3i position = at + Eigen::Vector3i(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
            if (n == 13 || !grid.contains(position)) {
                continue;
            }
            const auto neighbor = static_cast<std::uint32_t>(grid.index(position.x(), position.y(), position.z()));
            if (labels_[neighbor] != 0) {
                visit(neighbor, basinOf(labels_[neighbor]));
            }
        }
    }

    const DistanceMap& distances_;
    double minNeck_;
    std::vector<std::uint32_t> labels_;
    std::vector<Basin> basins_;
};

}   // namespace

std::vector<std::uint32_t> labelWideBasins(const DistanceMap& distances, double minNeck)
{
    return BasinFlooding(distances, minNeck).run();
}

}   // namespace angiopose::core
