#include "core/case/relative_view_pose.h"

#include "core/case/initial_pose.h"
#include "core/messages/messages.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

// Standard deviations (1 σ); DECISIONS gives their sources.
constexpr double tableRotationDeg = 0.75, tableShiftMm = 8.0;   // table known: breathing, heartbeat, tag rounding
constexpr double unknownLateralMm = 60.0, unknownDepthMm = 30.0;   // if table position or isocenter is unknown
constexpr double movingTableMm = 50.0;   // if the table moved during the acquisition of a view
constexpr double distanceToleranceMm = 1.0;
constexpr double simultaneityToleranceS = 1.0;

const GantryHeader* headerOf(const View& view)
{
    return view.angiogram ? &view.angiogram->gantry : nullptr;
}

bool isSameRun(const View& a, const View& b)
{
    const bool isOneFile = !a.imageFile.path.empty() && a.imageFile.path == b.imageFile.path;
    const bool isOneImage = a.angiogram && b.angiogram && !a.angiogram->identity.sopInstanceUid.empty() &&
                            a.angiogram->identity.sopInstanceUid == b.angiogram->identity.sopInstanceUid;
    return isOneFile || isOneImage;
}

bool isSimultaneous(const View& a, const View& b)
{
    const GantryHeader* of[] = {headerOf(a), headerOf(b)};
    if (!of[0] || !of[1] || !of[0]->biplane || !of[1]->biplane) {
        return false;
    }
    const BiplaneTime &first = *of[0]->biplane, &second = *of[1]->biplane;
    return first.plane != second.plane && first.date == second.date &&
           std::abs(first.timeS - second.timeS) <= simultaneityToleranceS;
}

bool isSameStudy(const View& a, const View& b)
{
    const std::string &first = a.angiogram->identity.studyUid, &second = b.angiogram->identity.studyUid;
    return first.empty() || second.empty() || first == second;
}

/// Returns the displacement of the isocenter in the patient between the views; nullopt if it is unknown.
std::optional<Eigen::Vector3d> isocenterStepMm(const View& first, const View& view)
{
    if (isSameRun(first, view) || isSimultaneous(first, view)) {
        return Eigen::Vector3d(Eigen::Vector3d::Zero());
    }
    const GantryHeader *before = headerOf(first), *after = headerOf(view);
    const bool isKnown = before && after && before->table && after->table &&
                         before->table->tags == after->table->tags && isSameStudy(first, view);
    return isKnown ? std::optional<Eigen::Vector3d>(after->table->isocenterInPatientMm -
                                                    before->table->isocenterInPatientMm)
                   : std::nullopt;
}

/// Whether the source distances determine the isocenter. An object plane used in place of the isocenter determines it
/// only if it is the same in both views.
bool isIsocenterKnown(const CArm& first, const CArm& view)
{
    const auto &a = first.sourceToIsocenterMm, &b = view.sourceToIsocenterMm;
    const bool isAssumed = (a.origin == Origin::Assumed && first.sourceToObjectMm.value) ||
                           (b.origin == Origin::Assumed && view.sourceToObjectMm.value);
    return !isAssumed || std::abs(*a.value - *b.value) <= distanceToleranceMm;
}

/// Returns the rotation of `step` with a translation that puts the vessels at their initial position in `view`.
RigidTransform withInitialPosition(const RigidTransform& step, const View& first, const View& view,
                                   const Vessels& vessels)
{
    const auto start = initialPoseOf(view, vessels);
    if (!start || !vessels.tree) {
        return step;
    }
    const Eigen::Vector3d centroid = centroidInPatient(*vessels.tree);
    return {step.rotation, start.value() * centroid - step.rotation * (first.cameraFromPatient * centroid)};
}

Result<RelativeViewPose> poseFromGantries(const View& first, const View& view, const Vessels& vessels)
{
    const CArm before = cArmOfFrame(first), after = cArmOfFrame(view);
    const auto step = isocenterStepMm(first, view);
    const auto gantryOfFirst = cameraFromPatient(before, Eigen::Vector3d::Zero());
    const auto gantry = cameraFromPatient(after, step.value_or(Eigen::Vector3d::Zero()));
    if (!gantryOfFirst || !gantry) {
        return gantry ? gantryOfFirst.error() : gantry.error();
    }
    RelativeViewPose found{gantry.value() * gantryOfFirst.value().inverse(), {}};
    const bool isSameAcquisition = isSimultaneous(first, view) || isSameRun(first, view);
    if (!isSameAcquisition) {
        found.spread = {tableRotationDeg, Eigen::Vector3d::Constant(tableShiftMm)};
    }
    const bool hasIsocenter = isIsocenterKnown(before, after);
    if (!step || !hasIsocenter) {
        const double alongMm = hasIsocenter ? unknownDepthMm : unknownLateralMm;
        found.spread = {tableRotationDeg, {unknownLateralMm, unknownLateralMm, alongMm}};
        found.viewFromFirst = withInitialPosition(found.viewFromFirst, first, view, vessels);
        found.notes.push_back(hasIsocenter ? messages::tableUnknown()
                                           : messages::isocenterUnknown(inMm(*before.sourceToIsocenterMm.value, 0),
                                                                        inMm(*after.sourceToIsocenterMm.value, 0)));
    }
    const bool moves =
        (headerOf(first) && headerOf(first)->tableMoves) || (headerOf(view) && headerOf(view)->tableMoves);
    if (moves && !isSimultaneous(first, view)) {
        found.spread.shiftMm = found.spread.shiftMm.cwiseMax(movingTableMm);
        found.notes.push_back(messages::tableMovedInView());
    }
    return found;
}

}   // namespace

Result<RelativeViewPose> relativeViewPose(const View& first, const View& view, const Vessels& vessels)
{
    auto fromGantries = poseFromGantries(first, view, vessels);
    if (fromGantries) {
        return fromGantries;
    }
    const auto startOfFirst = initialPoseOf(first, vessels);
    const auto start = initialPoseOf(view, vessels);
    if (!startOfFirst || !start) {
        return start ? startOfFirst.error() : start.error();
    }
    return RelativeViewPose{start.value() * startOfFirst.value().inverse(), {}};
}

}   // namespace angiopose::core
