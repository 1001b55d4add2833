#pragma once

#include "core/vessel/vessel_tree.h"

#include <cstddef>
#include <string>
#include <vector>

namespace angiopose::core {

enum class VesselMarkKind { CheckPoint, OstiumRing };

/// A named place on the vessels: a check point, by which a pose is judged, or the ring of an ostium.
struct VesselMark {
    int id = 0;   ///< unique among the marks of a case: views say by it where they see it
    VesselMarkKind kind = VesselMarkKind::CheckPoint;
    std::string name;
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< LPS, mm; of a ring its centre
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();   ///< of a ring: along its branch; unit
    double radiusMm = 0.0;   ///< of a ring
    std::string extraKeys{};   ///< JSON object with what a case file says of it that this version does not know

    bool operator==(const VesselMark&) const = default;
};

/// One more than the largest id.
int nextMarkId(const std::vector<VesselMark>& marks);

/// Points around a ring, evenly, the first one not repeated.
std::vector<Eigen::Vector3d> ringPoints(const VesselMark& ring, std::size_t count);

/// The mark where it goes when its vessels take another shape: both trees have the same branches and points. It keeps
/// its way to the nearest place of the vessels; a ring turns with its branch. As it was where the trees do not match.
VesselMark movedWith(const VesselTree& from, const VesselTree& to, VesselMark mark);

}   // namespace angiopose::core
