#include "app/texts/bent_vessels.h"

#include "app/messages/says.h"
#include "core/case/known_bend.h"
#include "core/registration/deformable/bent_tree.h"

#include <algorithm>
#include <array>
#include <utility>

namespace angiopose::app {
namespace {

/// The first round number that holds the largest motion.
double motionScaleMm(double largestMm)
{
    constexpr std::array ends{1.0, 2.0, 5.0, 10.0, 20.0, 50.0};
    const auto end = std::ranges::lower_bound(ends, largestMm);
    return end == ends.end() ? ends.back() : *end;
}

MotionMap motionMap(const core::VesselTree& rigid, const core::VesselTree& bent, const core::RigidTransform& pose,
                    std::size_t viewCount)
{
    MotionMap map;
    for (std::size_t b = 0; b < bent.branches.size(); ++b) {
        std::vector<double>& apartMm = map.distanceMm[rigid.branches[b].id];
        apartMm = core::distancesApart(rigid.branches[b], bent.branches[b], pose, viewCount);
        for (const double mm : apartMm) {
            map.largestMm = std::max(map.largestMm, mm);
        }
    }
    map.scaleMaximumMm = motionScaleMm(map.largestMm);
    return map;
}

/// Of the run in which a bend was found, where the one that is shown is another.
std::optional<int> otherFrameOf(const core::View& view, const core::RigidTransform& pose,
                                const core::DeformableResult& bent)
{
    const core::FollowedFrame* followed = core::bendAt(view.followed, pose);
    if (followed && followed->bent.get() == &bent) {
        return followed->bentAsInFrame;
    }
    const bool isElsewhere = view.result && view.result->bent.get() == &bent && !core::resultOfShownFrame(view);
    return isElsewhere ? view.result->provenance.frame : std::nullopt;
}

}   // namespace

std::shared_ptr<const core::DeformableResult> drawableBend(const core::View& view, const core::Vessels& vessels,
                                                           const core::RigidTransform& pose)
{
    return core::knownBend(view, vessels, pose);
}

DrawnVessels drawnVessels(const core::View& view, const core::Vessels& vessels, const core::RigidTransform& pose,
                          VesselShape wanted)
{
    DrawnVessels drawn;
    if (!vessels.tree) {
        return drawn;
    }
    drawn.tree = *vessels.tree;
    drawn.known = drawableBend(view, vessels, pose);
    if (drawn.known) {
        core::VesselTree bent = core::bentTreeAt(*vessels.tree, *drawn.known, pose);
        drawn.motion = motionMap(*vessels.tree, bent, pose, drawn.known->viewPoses.size());
        drawn.shape = wanted;
        drawn.otherFrame = otherFrameOf(view, pose, *drawn.known);
        if (wanted == VesselShape::Bent) {
            drawn.tree = std::move(bent);
        }
    }
    return drawn;
}

core::Messages shapeLines(const DrawnVessels& drawn)
{
    if (!drawn.known) {
        return {};
    }
    if (drawn.shape == VesselShape::Rigid) {
        return {says::vesselsRigid()};
    }
    const core::Quantity most = core::inMm(drawn.motion.largestMm, 1);
    const bool isSure = drawn.known->verdict == core::BendVerdict::Bent;
    core::Messages lines{isSure ? says::vesselsBent(most) : says::vesselsBentUnsure(most)};
    if (drawn.otherFrame) {
        lines.push_back(says::bentOnFrame(*drawn.otherFrame + 1));
    }
    if (drawn.known->viewPoses.size() == 1) {
        lines.push_back(says::bentDepthUntold());
    }
    return lines;
}

core::Message motionHeading()
{
    return says::motionScale();
}

}   // namespace angiopose::app
