#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Interface for finding the nearest of a fixed set of image points. Lookups never allocate and are thread-safe.
class PointIndex {
public:
    virtual ~PointIndex() = default;

    /// Returns the index of the point nearest to a finite pixel position.
    virtual std::size_t nearestIndex(const Eigen::Vector2d& queryPx) const = 0;

    virtual const std::vector<Eigen::Vector2d>& points() const = 0;

    /// Returns the point nearest to a finite pixel position.
    const Eigen::Vector2d& nearest(const Eigen::Vector2d& queryPx) const { return points()[nearestIndex(queryPx)]; }
};

}   // namespace angiopose::core
