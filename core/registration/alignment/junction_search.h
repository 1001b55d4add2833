#pragma once

#include "core/registration/alignment/coarse_search.h"
#include "core/registration/alignment/junctions.h"

#include <cstdint>

namespace angiopose::core {

/// Finds initial poses from bifurcations (ALGORITHMS §6.9). For every tilt in range, aligning two nodes of the tree
/// with two junctions of the traced vessels fixes the roll, both shifts and, through their distance, the depth. If the
/// branch directions match at both, the fit is scored by the number of remaining nodes that also coincide with a
/// junction; the best fits are ranked by the closeness of the whole tree to the vessels. The number of bases tried is
/// limited, deterministic and spread evenly over the tree. Covers a wider range than CoarseSearch, which keeps the
/// depth fixed, in less time.
class JunctionSearch {
public:
    JunctionSearch(const RegistrationProblem& problem, const TargetLines& target);

    /// Returns the best distinct candidates, best first; scores and `proceed` are as in CoarseSearch.
    std::vector<CoarseCandidate> find(const CentroidPose& start, const SearchRange& range,
                                      const std::function<ObserverDecision(double)>& observe) const;

private:
    /// Set of image directions with one bit per sector of 1/64 turn; rotating the image rotates the bits.
    using DirectionBits = std::uint64_t;

    /// A traced junction, or a tree node projected at one tilt.
    struct ImageNode {
        Eigen::Vector2d px;   ///< relative to the principal point, camera axes
        DirectionBits ways;
    };
    /// Vector between two junctions or between two nodes.
    struct Base {
        double lengthPx;
        Eigen::Vector2d along;   ///< unit vector
        double sectors;   ///< direction in sectors of 1/64 turn
        int from, to;
    };
    /// Transform that aligns two tree nodes with two traced junctions.
    struct Fit {
        int matchedNodeCount = 0;   ///< number of nodes that coincide with junctions
        double zoom = 1.0;
        Eigen::Vector2d turn;   ///< (cos, sin) of the roll
        Eigen::Vector2d centroidPx;   ///< relative to the principal point, as in ImageNode
    };

    static DirectionBits directionBits(std::span<const Eigen::Vector2d> directions, int spread);
    static Base baseOf(const std::vector<ImageNode>& places, int from, int to);
    void markJunctions(std::span<const Junction<2>> found);
    void collectBases();
    std::vector<ImageNode> projectNodes(const Eigen::Matrix3d& rotation, double depthMm) const;
    std::vector<Fit> findFits(const std::vector<ImageNode>& nodes, double maxRoll, std::size_t budget) const;
    std::size_t tryBase(const Base& base, const std::vector<ImageNode>& nodes, double maxRoll,
                        std::vector<Fit>& fits) const;
    int matchedNodeCount(const std::vector<ImageNode>& nodes, const Fit& fit) const;
    CentroidPose poseOf(const Fit& fit, const Eigen::Matrix3d& view, double depthMm) const;
    double closeness(const CentroidPose& pose) const;

    ProjectionCamera camera_;
    const TargetLines& target_;
    std::vector<Junction<3>> nodes_;   ///< tree nodes relative to the tree's centroid
    std::vector<ImageNode> junctions_;
    std::vector<Base> bases_;   ///< bases between traced junctions, in ascending order of length
    std::vector<std::uint8_t> isNearJunction_;   ///< 1 for image cells near a traced junction
    int columns_ = 0;
    int rows_ = 0;
    std::vector<AlignmentPoint> points_;
};

}   // namespace angiopose::core
