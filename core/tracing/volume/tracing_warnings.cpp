#include "core/tracing/volume/tracing_warnings.h"

#include "core/messages/says.h"
#include "core/tracing/volume/voxels/chosen_pieces.h"

#include <cmath>

namespace angiopose::core {

Message loopWarning(int loops)
{
    return loops == 1 ? says::oneLoopOpened() : says::loopsOpened(loops);
}

Message gapWarning(const ClosedGaps& gaps)
{
    return says::gapsClosed(gaps.count, inMm(gaps.longestMm, 1));
}

Message coverWarning(const SkeletonCover& cover)
{
    return says::skeletonNotFollowed(Quantity{std::floor(100.0 * cover.share), 0, "%"},
                                     placeInMessage(cover.missedInPatient.value_or(Eigen::Vector3d::Zero())));
}

Message unitWarning()
{
    return says::perhapsNoHounsfield();
}

Message dimWarning(int parts)
{
    return parts == 1 ? says::oneDimPartLeftOut() : says::dimPartsLeftOut(parts);
}

Message besideWarning(const OtherLumen& other)
{
    return says::otherLumenBeside(Quantity{other.besideMm / 10.0, 0, "cm"}, placeInMessage(other.placeInPatient));
}

std::optional<Eigen::Vector3d> otherLumenOf(const Messages& warnings)
{
    for (const Message& warning : warnings) {
        if (warning.is(says::otherLumenBeside)) {
            const std::vector<MessageArgument>& at = std::get<Messages>(warning.arguments()[1]).front().arguments();
            return Eigen::Vector3d(std::get<Quantity>(at[0]).value, std::get<Quantity>(at[1]).value,
                                   std::get<Quantity>(at[2]).value);
        }
    }
    return std::nullopt;
}

Message startWarning(const std::optional<Eigen::Vector3d>& foundStart)
{
    return foundStart ? says::noSeedFoundVessel(placeInMessage(*foundStart)) : says::noSeedLargestPiece();
}

}   // namespace angiopose::core
