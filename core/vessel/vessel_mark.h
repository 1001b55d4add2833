#pragma once

#include "core/vessel/vessel_tree.h"

#include <cstddef>
#include <string>
#include <vector>

namespace angiopose::core {

enum class VesselMarkKind { TargetPoint, OstiumRing };

/// A named mark on the vessels: a target point for evaluating a pose, or the ring of an ostium.
struct VesselMark {
    int id = 0;   ///< unique among the marks of a case; used by the observations in the views
    VesselMarkKind kind = VesselMarkKind::TargetPoint;
    std::string name;
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< LPS, mm; for a ring, its center
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();   ///< for rings only: unit vector along the branch
    double radiusMm = 0.0;   ///< for rings only
    std::string extraKeys{};   ///< JSON object with the case-file keys that this version does not recognize

    bool operator==(const VesselMark&) const = default;
};

/// Returns one more than the largest id.
int nextMarkId(const std::vector<VesselMark>& marks);

/// Returns evenly spaced points around a ring, without repeating the first.
std::vector<Eigen::Vector3d> ringPoints(const VesselMark& ring, std::size_t count);

/// Moves a mark together with deforming vessels. Both trees must have the same branches and points; otherwise the mark
/// stays unchanged. The mark keeps its offset to the nearest point of the vessels, and a ring rotates with its branch.
VesselMark moveWithVessels(const VesselTree& from, const VesselTree& to, VesselMark mark);

}   // namespace angiopose::core
