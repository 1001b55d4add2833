#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace angiopose::core {

/// Finds several near target points in the image.
class NeighborSearch {
public:
    virtual ~NeighborSearch() = default;

    /// The `count` nearest of the points within `radiusPx` of a finite pixel, nearest first.
    virtual void find(const Eigen::Vector2d& queryPx, std::size_t count, double radiusPx,
                      std::vector<Eigen::Vector2d>& foundPx) const = 0;
};

/// Exact, by KD-tree; `pointsPx` finite and not empty.
std::unique_ptr<NeighborSearch> makeNeighborSearch(std::vector<Eigen::Vector2d> pointsPx);

}   // namespace angiopose::core