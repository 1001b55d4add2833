#include "core/case/vessels.h"

namespace angiopose::core {

std::optional<Eigen::Vector3d> pivotInPatient(const Vessels& vessels)
{
    if (!vessels.tree) {
        return std::nullopt;
    }
    return vessels.pickedPivotInPatient.value_or(centroidInPatient(*vessels.tree));
}

}   // namespace angiopose::core
