#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace angiopose::core {

/// Interface for finding several nearby target points in the image.
class NeighborSearch {
public:
    virtual ~NeighborSearch() = default;

    /// Finds the `count` nearest points within `radiusPx` of a finite pixel, nearest first.
    virtual void find(const Eigen::Vector2d& queryPx, std::size_t count, double radiusPx,
                      std::vector<Eigen::Vector2d>& foundPx) const = 0;
};

/// Creates an exact k-d tree search; `pointsPx` must be finite and not empty.
std::unique_ptr<NeighborSearch> makeNeighborSearch(std::vector<Eigen::Vector2d> pointsPx);

}   // namespace angiopose::core
