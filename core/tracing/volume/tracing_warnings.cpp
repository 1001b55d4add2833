#include "core/tracing/volume/tracing_warnings.h"

#include "core/messages/messages.h"
#include "core/tracing/volume/voxels/component_selection.h"

#include <cmath>

namespace angiopose::core {

Message loopWarning(int loops)
{
    return loops == 1 ? messages::oneLoopOpened() : messages::loopsOpened(loops);
}

Message gapWarning(const ClosedGaps& gaps)
{
    return messages::gapsClosed(gaps.count, inMm(gaps.maxGapMm, 1));
}

Message coverageWarning(const SkeletonCoverage& cover)
{
    return messages::skeletonNotFollowed(Quantity{std::floor(100.0 * cover.fraction), 0, "%"},
                                         formatPoint(cover.missedInPatient.value_or(Eigen::Vector3d::Zero())));
}

Message unitWarning()
{
    return messages::possiblyNotHounsfield();
}

Message dimSubtreeWarning(int parts)
{
    return parts == 1 ? messages::oneDimPartLeftOut() : messages::dimPartsLeftOut(parts);
}

Message adjacentLumenWarning(const AdjacentLumen& other)
{
    return messages::possibleFalseLumen(Quantity{other.adjacentMm / 10.0, 0, "cm"},
                                        formatPoint(other.positionInPatient));
}

std::optional<Eigen::Vector3d> adjacentLumenPosition(const Messages& warnings)
{
    for (const Message& warning : warnings) {
        if (warning.is(messages::possibleFalseLumen)) {
            const std::vector<MessageArgument>& at = std::get<Messages>(warning.arguments()[1]).front().arguments();
            return Eigen::Vector3d(std::get<Quantity>(at[0]).value, std::get<Quantity>(at[1]).value,
                                   std::get<Quantity>(at[2]).value);
        }
    }
    return std::nullopt;
}

Message startWarning(const std::optional<Eigen::Vector3d>& foundStart)
{
    return foundStart ? messages::noSeedVesselFound(formatPoint(*foundStart)) : messages::noSeedLargestComponent();
}

}   // namespace angiopose::core
