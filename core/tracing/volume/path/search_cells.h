#pragma once

#include "core/imaging/volume.h"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace angiopose::core {

/// State of a voxel in a bidirectional search.
struct SearchCell {
    static constexpr std::uint8_t noArrival = 255;
    static constexpr float unknown = -1.0F;

    float perMm = unknown;
    std::array<float, 2> distance{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};
    std::array<std::uint8_t, 2> arrivalStep{noArrival, noArrival};   ///< step by which each search front arrived here
};

/// Cells of a box of voxels, allocated in tiles on demand because a search visits only a small part of its box.
class SearchCells {
public:
    explicit SearchCells(const Eigen::Vector3i& size)
        : tileCounts_((size.array() + static_cast<int>(side) - 1) / static_cast<int>(side)),
          tiles_(static_cast<std::size_t>(tileCounts_.x()) * static_cast<std::size_t>(tileCounts_.y()) *
                 static_cast<std::size_t>(tileCounts_.z()))
    {
    }

    SearchCell& at(const Eigen::Vector3i& voxel)
    {
        const auto [i, j, k] = std::array{static_cast<unsigned>(voxel.x()), static_cast<unsigned>(voxel.y()),
                                          static_cast<unsigned>(voxel.z())};
        const auto [tilesI, tilesJ] =
            std::array{static_cast<std::size_t>(tileCounts_.x()), static_cast<std::size_t>(tileCounts_.y())};
        std::unique_ptr<Tile>& tile = tiles_[(k / side * tilesJ + j / side) * tilesI + i / side];
        if (!tile) {
            tile = std::make_unique<Tile>();
        }
        return (*tile)[(k % side * side + j % side) * side + i % side];
    }

private:
    static constexpr unsigned side = 16;
    using Tile = std::array<SearchCell, std::size_t{side} * side * side>;

    Eigen::Vector3i tileCounts_;
    std::vector<std::unique_ptr<Tile>> tiles_;
};

}   // namespace angiopose::core
