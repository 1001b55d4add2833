#pragma once

#include "core/registration/alignment/coarse_search.h"
#include "core/registration/alignment/junctions.h"

#include <cstdint>

namespace angiopose::core {

/// Start poses from bifurcations (ALGORITHMS §6.9): for every tilt in reach, two nodes of the tree laid on two
/// junctions of the traced vessels fix roll, both shifts and, by their distance, the depth. Where branches leave both
/// in like directions, the other nodes are asked how many of them meet a junction too; the best are ranked by how near
/// the whole tree comes to the vessels. So many bases are tried in all, however many there are: the same on every run,
/// spread evenly over the tree's. Reaches farther than CoarseSearch, which knows no depth, for less time.
class JunctionSearch {
public:
    JunctionSearch(const RegistrationProblem& problem, const TargetLines& target);

    /// Best candidates, different from each other, best first; scores as in CoarseSearch. `proceed` as there.
    std::vector<CoarseCandidate> find(const CentroidPose& start, const SearchReach& reach,
                                      const std::function<Verdict(double)>& proceed) const;

private:
    /// Directions in the image, one bit for each of 64 equal sectors: turning is rotating.
    using Ways = std::uint64_t;

    /// A junction, or a node as one tilt shows it.
    struct Place {
        Eigen::Vector2d px;   ///< from the principal point, axes of the camera
        Ways ways;
    };
    /// From one place to another.
    struct Base {
        double lengthPx;
        Eigen::Vector2d along;   ///< unit
        double sectors;   ///< direction, 64 to the full turn
        int from, to;
    };
    /// Two nodes laid on two junctions.
    struct Fit {
        int meetings = 0;   ///< nodes that come to lie on junctions
        double zoom = 1.0;
        Eigen::Vector2d turn;   ///< (cos, sin) of the roll
        Eigen::Vector2d centroidPx;   ///< as Place
    };

    static Ways waysOf(std::span<const Eigen::Vector2d> directions, int spread);
    static Base baseOf(const std::vector<Place>& places, int from, int to);
    void drawMeetings(std::span<const Junction<2>> found);
    void listBases();
    std::vector<Place> nodesSeen(const Eigen::Matrix3d& rotation, double depthMm) const;
    std::vector<Fit> fitsOf(const std::vector<Place>& nodes, double longestRoll, std::size_t budget) const;
    std::size_t tryBase(const Base& base, const std::vector<Place>& nodes, double longestRoll,
                        std::vector<Fit>& fits) const;
    int meetings(const std::vector<Place>& nodes, const Fit& fit) const;
    CentroidPose poseOf(const Fit& fit, const Eigen::Matrix3d& view, double depthMm) const;
    double closeness(const CentroidPose& pose) const;

    ProjectionCamera camera_;
    const TargetLines& target_;
    std::vector<Junction<3>> nodes_;   ///< relative to the tree's centroid
    std::vector<Place> junctions_;
    std::vector<Base> bases_;   ///< between junctions, ascending in length
    std::vector<std::uint8_t> isNearJunction_;   ///< cells of the image
    int columns_ = 0;
    int rows_ = 0;
    std::vector<AlignmentPoint> points_;
};

}   // namespace angiopose::core