#include "app/texts/deformed_vessels.h"

#include "app/messages/messages.h"
#include "core/case/known_deformation.h"
#include "core/registration/deformable/deformed_tree.h"

#include <algorithm>
#include <array>
#include <utility>

namespace angiopose::app {
namespace {

/// Returns the smallest round maximum of the scale that covers the largest displacement.
double motionScaleMm(double maxMm)
{
    constexpr std::array ends{1.0, 2.0, 5.0, 10.0, 20.0, 50.0};
    const auto end = std::ranges::lower_bound(ends, maxMm);
    return end == ends.end() ? ends.back() : *end;
}

DisplacementMap motionMap(const core::VesselTree& rigid, const core::VesselTree& deformed,
                          const core::RigidTransform& pose, std::size_t viewCount)
{
    DisplacementMap map;
    for (std::size_t b = 0; b < deformed.branches.size(); ++b) {
        std::vector<double>& apartMm = map.distanceMm[rigid.branches[b].id];
        apartMm = core::pointDistances(rigid.branches[b], deformed.branches[b], pose, viewCount);
        for (const double mm : apartMm) {
            map.maxMm = std::max(map.maxMm, mm);
        }
    }
    map.scaleMaximumMm = motionScaleMm(map.maxMm);
    return map;
}

/// Returns the frame in which the deformation was determined if that is not the shown frame.
std::optional<int> otherFrameOf(const core::View& view, const core::RigidTransform& pose,
                                const core::DeformableResult& deformed)
{
    const core::TrackedRunFrame* followed = core::findDeformedFrame(view.followed, pose);
    if (followed && followed->deformed.get() == &deformed) {
        return followed->deformationSourceFrame;
    }
    const bool isElsewhere = view.result && view.result->deformed.get() == &deformed && !core::resultOfShownFrame(view);
    return isElsewhere ? view.result->provenance.frame : std::nullopt;
}

}   // namespace

std::shared_ptr<const core::DeformableResult> deformationForPose(const core::View& view, const core::Vessels& vessels,
                                                                 const core::RigidTransform& pose)
{
    return core::knownDeformation(view, vessels, pose);
}

DrawnVessels vesselsToDraw(const core::View& view, const core::Vessels& vessels, const core::RigidTransform& pose,
                           VesselShape preferredShape)
{
    DrawnVessels drawn;
    if (!vessels.tree) {
        return drawn;
    }
    drawn.tree = *vessels.tree;
    drawn.known = deformationForPose(view, vessels, pose);
    if (drawn.known) {
        core::VesselTree deformed = core::deformedTreeAt(*vessels.tree, *drawn.known, pose);
        drawn.motion = motionMap(*vessels.tree, deformed, pose, drawn.known->viewPoses.size());
        drawn.shape = preferredShape;
        drawn.otherFrame = otherFrameOf(view, pose, *drawn.known);
        if (preferredShape == VesselShape::Deformed) {
            drawn.tree = std::move(deformed);
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
        return {messages::vesselsRigid()};
    }
    const core::Quantity most = core::inMm(drawn.motion.maxMm, 1);
    const bool isSure = drawn.known->verdict == core::DeformationVerdict::Deformed;
    core::Messages lines{isSure ? messages::vesselsDeformed(most) : messages::vesselsDeformedUnsure(most)};
    if (drawn.otherFrame) {
        lines.push_back(messages::deformedOnFrame(*drawn.otherFrame + 1));
    }
    if (drawn.known->viewPoses.size() == 1) {
        lines.push_back(messages::deformedDepthUnknown());
    }
    return lines;
}

core::Message motionHeading()
{
    return messages::motionScale();
}

}   // namespace angiopose::app
