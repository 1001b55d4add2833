#include "core/tracing/volume/tracing_warnings.h"

#include "core/messages/messages.h"
#include "core/tracing/volume/voxels/chosen_pieces.h"

#include <cmath>

namespace angiopose::core {

Message loopWarning(int loops)
{
    return loops == 1 ? messages::oneLoopOpened() : messages::loopsOpened(loops);
}

Message gapWarning(const ClosedGaps& gaps)
{
    return messages::gapsClosed(gaps.count, inMm(gaps.longestMm, 1));
}

Message coverWarning(const SkeletonCover& cover)
{
    return messages::skeletonNotFollowed(Quantity{std::floor(100.0 * cover.share), 0, "%"},
                                         placeInMessage(cover.missedInPatient.value_or(Eigen::Vector3d::Zero())));
}

Message unitWarning()
{
    return messages::perhapsNoHounsfield();
}

Message dimWarning(int parts)
{
    return parts == 1 ? messages::oneDimPartLeftOut() : messages::dimPartsLeftOut(parts);
}

Message besideWarning(const OtherLumen& other)
{
    return messages::otherLumenBeside(Quantity{other.besideMm / 10.0, 0, "cm"}, placeInMessage(other.placeInPatient));
}

std::optional<Eigen::Vector3d> otherLumenOf(const Messages& warnings)
{
    for (const Message& warning : warnings) {
        if (warning.is(messages::otherLumenBeside)) {
            const std::vector<MessageArgument>& at = std::get<Messages>(warning.arguments()[1]).front().arguments();
            return Eigen::Vector3d(std::get<Quantity>(at[0]).value, std::get<Quantity>(at[1]).value,
                                   std::get<Quantity>(at[2]).value);
        }
    }
    return std::nullopt;
}

Message startWarning(const std::optional<Eigen::Vector3d>& foundStart)
{
    return foundStart ? messages::noSeedFoundVessel(placeInMessage(*foundStart)) : messages::noSeedLargestPiece();
}

}   // namespace angiopose::core
