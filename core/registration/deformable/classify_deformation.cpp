#include "core/registration/deformable/classify_deformation.h"

#include "core/messages/messages.h"
#include "core/registration/deformable/deform_vessels.h"
#include "core/registration/deformable/deformed_result.h"
#include "core/support/quantile.h"
#include "core/vessel/polyline.h"

#include <array>
#include <cmath>
#include <optional>

namespace angiopose::core {
namespace {

/// Part of the tree on one side of a plane normal to a patient axis that moved as a rigid body relative to the rest.
struct MovedPart {
    Eigen::Vector3d side;   ///< unit vector in patient axes, toward the part's side of the plane
    double share = 0.0;   ///< fraction of the tree's length
    Eigen::Vector3d shift;   ///< mean motion of the part relative to the rest, mm, patient axes
};

constexpr std::array<double, 7> cutsTried{0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8};
constexpr double maxUnexplained = 0.35;   // fraction of the squared motion left unexplained by two rigid parts
constexpr double minPartShiftMm = 2.0;
constexpr double samplesMm = 5.0;

/// Evenly spaced tree positions before and after the motion.
struct MovedSamples {
    std::vector<Eigen::Vector3d> before;
    std::vector<Eigen::Vector3d> after;

    void add(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
    {
        before.push_back(from);
        after.push_back(to);
    }
    RigidTransform rigid() const { return fitRigidTransform(before, after, std::vector<double>(before.size(), 1.0)); }
    double leftOver(const RigidTransform& rigidly) const
    {
        double sum = 0.0;
        for (std::size_t k = 0; k < before.size(); ++k) {
            sum += (rigidly * before[k] - after[k]).squaredNorm();
        }
        return sum;
    }
};

MovedSamples movedSamplesOf(const VesselTree& tree, const DeformableResult& result)
{
    MovedSamples samples;
    for (std::size_t b = 0; b < tree.branches.size(); ++b) {
        const auto& points = tree.branches[b].pointsInPatient;
        const auto stations = evenStations<3>(points, samplesMm);
        const auto places = interpolate(points, stations);
        const auto motions = interpolate(result.branches[b].displacementMm, stations);
        for (std::size_t k = 0; k < places.size(); ++k) {
            samples.add(places[k], places[k] + motions[k]);
        }
    }
    return samples;
}

/// Returns the smaller of two rigidly moving parts that together explain most of the motion, if such parts exist.
std::optional<MovedPart> movedPart(const VesselTree& tree, const DeformableResult& result)
{
    const MovedSamples all = movedSamplesOf(tree, result);
    double least = maxUnexplained * all.leftOver(all.rigid());
    std::optional<MovedPart> found;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        std::vector<double> heights;
        for (const Eigen::Vector3d& place : all.before) {
            heights.push_back(place[axis]);
        }
        for (const double cut : cutsTried) {
            const double height = quantile(heights, cut);
            MovedSamples low;
            MovedSamples high;
            for (std::size_t k = 0; k < all.before.size(); ++k) {
                (heights[k] < height ? low : high).add(all.before[k], all.after[k]);
            }
            if (low.before.empty() || high.before.empty()) {
                continue;
            }
            const double left = low.leftOver(low.rigid()) + high.leftOver(high.rigid());
            if (left >= least) {
                continue;
            }
            least = left;
            const bool isHighSmaller = high.before.size() <= low.before.size();
            const MovedSamples& part = isHighSmaller ? high : low;
            const RigidTransform restRigid = (isHighSmaller ? low : high).rigid();
            MovedPart moved;
            moved.side = (isHighSmaller ? 1.0 : -1.0) * Eigen::Vector3d::Unit(axis);
            moved.share = static_cast<double>(part.before.size()) / static_cast<double>(all.before.size());
            moved.shift.setZero();
            for (std::size_t k = 0; k < part.before.size(); ++k) {
                moved.shift += (part.after[k] - restRigid * part.before[k]) / static_cast<double>(part.before.size());
            }
            found = moved;
        }
    }
    return found && found->shift.norm() >= minPartShiftMm ? found : std::nullopt;
}

constexpr double convincingGain = 10.0;   // minimum log evidence for deformation
constexpr double maxFitSpreadMm = 0.5;   // maximum difference between fits that match the same branches
constexpr double minExplained = 0.4;   // minimum matched fraction of the visible tree
constexpr double maxResidualPx = 1.2;   // larger median residuals indicate motion that was not captured

Message sideMessage(const Eigen::Vector3d& direction)
{
    Eigen::Index axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    const bool isUp = direction[axis] > 0.0;
    switch (axis) {
        case 0:
            return isUp ? messages::sideLeft() : messages::sideRight();
        case 1:
            return isUp ? messages::sideBack() : messages::sideFront();
        default:
            return isUp ? messages::sideHead() : messages::sideFeet();
    }
}

void restoreRigid(std::span<const DeformableView> views, DeformableResult& result)
{
    DeformableResult rigid = rigidResult(views);
    for (std::size_t b = 0; b < rigid.branches.size(); ++b) {
        result.branches[b].displacementMm = std::move(rigid.branches[b].displacementMm);
    }
    result.cameraFromPatient = rigid.cameraFromPatient;
    result.viewPoses = std::move(rigid.viewPoses);
    result.largestMotionMm = 0.0;
    result.meanMotionMm = 0.0;
}

}   // namespace

void classifyDeformation(std::span<const DeformableView> views, DeformableResult& result)
{
    if (result.stopReason == StopReason::StoppedByUser) {
        result.verdict = DeformationVerdict::Unsure;
        result.messages.push_back(messages::deformationStopped());
        return;
    }
    const bool isSure =
        result.spreadMm <= maxFitSpreadMm && result.explainedShare >= minExplained && result.noisePx <= maxResidualPx;
    if (result.spreadMm > maxFitSpreadMm) {
        result.messages.push_back(messages::deformationRunsDiffer(inMm(result.spreadMm, 1)));
    }
    if (result.explainedShare < minExplained) {
        result.messages.push_back(messages::deformationLittleMatched(Quantity{100.0 * result.explainedShare, 0, "%"}));
    }
    if (result.logEvidenceGain < convincingGain) {
        result.verdict = DeformationVerdict::Rigid;
        restoreRigid(views, result);
        return;
    }
    result.verdict = isSure ? DeformationVerdict::Deformed : DeformationVerdict::Unsure;
    if (result.noisePx > maxResidualPx) {
        result.messages.push_back(messages::deformationResidual(Quantity{result.noisePx, 1, "px"}));
    }
    if (const auto part = movedPart(views.front().input.tree, result)) {
        result.messages.push_back(messages::deformationPartMoved(sideMessage(part->side),
                                                                 Quantity{100.0 * part->share, 0, "%"},
                                                                 inMm(part->shift.norm(), 1), sideMessage(part->shift))
                                      .as(Severity::Note));
    }
    if (views.size() == 1) {
        result.messages.push_back(messages::deformationDepthUnknown().as(Severity::Note));
    }
}

std::string_view toText(DeformationVerdict verdict)
{
    switch (verdict) {
        case DeformationVerdict::Rigid:
            return "rigid";
        case DeformationVerdict::Deformed:
            return "bent";
        case DeformationVerdict::Unsure:
            return "unsure";
    }
    return "";
}

}   // namespace angiopose::core
