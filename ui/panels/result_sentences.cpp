#include "ui/panels/result_sentences.h"

#include "core/messages/messages.h"
#include "core/registration/deformable/deform_vessels.h"
#include "core/registration/deformation_check.h"
#include "core/registration/judging/mismatched_branches.h"
#include "core/registration/judging/pose_uncertainty.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"

#include <QCoreApplication>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr double agreeingMm = 0.5;   ///< branches with a median residual up to this value count as agreeing

/// Translation context for the sentences in this file.
struct ResultWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::ui::ResultSentences)
};

QString resultNumber(double value)
{
    return numberText(value, value < 9.95 ? 1 : 0);
}

/// Returns the standard deviations for an exact geometry, which are the only ones in results of earlier versions.
core::PoseSigmas byImage(const core::PoseUncertainty& uncertainty)
{
    const bool isKnown = uncertainty.imageCovariance.diagonal().maxCoeff() > 0.0;
    return isKnown ? core::sigmasOf(uncertainty.imageCovariance)
                   : core::PoseSigmas{uncertainty.rotationDeg, uncertainty.inPlaneMm, uncertainty.depthMm};
}

QString certainPose(const core::PoseUncertainty& uncertainty)
{
    const core::PoseSigmas sigmas = byImage(uncertainty);
    const bool inPlane = uncertainty.observed[3] && uncertainty.observed[4];
    const bool turns = uncertainty.observed[0] && uncertainty.observed[1] && uncertainty.observed[2];
    const QString shiftMm = resultNumber(std::max(0.05, sigmas.inPlaneMm));
    const QString turnDeg = resultNumber(std::max(0.05, sigmas.rotationDeg.maxCoeff()));
    if (inPlane && turns) {
        return ResultWords::tr("In plane ±%1 mm, rotation ±%2°.").arg(shiftMm, turnDeg);
    }
    return inPlane ? ResultWords::tr("In plane ±%1 mm.").arg(shiftMm)
           : turns ? ResultWords::tr("Rotation ±%1°.").arg(turnDeg)
                   : QString();
}

QString agreement(const std::vector<core::BranchResidual>& branches, double mmPerPx)
{
    const auto agrees = [mmPerPx](const core::BranchResidual& branch) {
        return branch.pointCount > 0 && branch.medianPx * mmPerPx <= agreeingMm;
    };
    const auto count = std::ranges::count_if(branches, agrees);
    return ResultWords::tr("%1 of %2 branches agree within %3 mm.")
        .arg(count)
        .arg(branches.size())
        .arg(numberText(agreeingMm, 1));
}

/// Formats a probability in percent, e.g. "97", limited to 1–99, the range of the calibration.
QString percentText(double probability)
{
    return numberText(std::clamp(100.0 * probability, 1.0, 99.0), 0);
}

/// States the calibrated probability if available; omits it if it contradicts a result of an earlier version.
QString likelihood(const core::RegistrationResult& result)
{
    constexpr double trusted = 0.8;
    const bool agrees = result.trustworthy || result.probabilityWithin2Mm.value_or(0.0) < trusted;
    return result.probabilityWithin2Mm && agrees
               ? ResultWords::tr("The overlay is within 2 mm of the vessels with a probability of %1 %.")
                     .arg(percentText(*result.probabilityWithin2Mm))
                     .replace(QStringLiteral(" %"), QStringLiteral("\u00a0%"))   // no-break space
               : QString();
}

/// Returns whether geometry errors contribute clearly more to the depth uncertainty than the image does.
bool dependsOnGeometry(const core::PoseUncertainty& uncertainty)
{
    return uncertainty.depthMm > 1.5 * byImage(uncertainty).depthMm && uncertainty.depthMm > 1.0;
}

/// States the 3-D uncertainty including geometry errors, which the image cannot correct and which do not affect the
/// overlay.
QString geometryText(const core::PoseUncertainty& uncertainty)
{
    return dependsOnGeometry(uncertainty)
               ? ResultWords::tr("3-D uncertainty incl. geometry: depth ±%1 mm, lateral ±%2 mm.")
                     .arg(resultNumber(uncertainty.depthMm), resultNumber(uncertainty.inPlaneMm))
               : QString();
}

/// States the depth uncertainty; empty if a solver warning or the geometry sentence already mentions depth.
QString depthText(const core::RegistrationResult& result)
{
    const core::PoseUncertainty& uncertainty = result.uncertainty;
    const auto speaksOfDepth = [](const core::Message& warning) {
        return warning.is(core::messages::depthUndetermined) || warning.is(core::messages::depthChangeUndetermined);
    };
    if (std::ranges::any_of(result.warnings, speaksOfDepth)) {
        return {};
    }
    const std::optional<double> depthMm = uncertainDepthMm(uncertainty);
    if (!depthMm || (uncertainty.observed[5] && dependsOnGeometry(uncertainty))) {
        return {};
    }
    return uncertainty.observed[5]
               ? ResultWords::tr("Depth is the least certain: ±%1 mm.").arg(resultNumber(*depthMm))
               : ResultWords::tr("Depth ±%1 mm: not determined by a single view.").arg(resultNumber(*depthMm));
}

/// Names the branches with large residuals that are neither reported as unopacified nor explained by deformation nor
/// near a guidewire.
QString disagreement(const core::RegistrationResult& result, const core::VesselTree& tree, double mmPerPx)
{
    const core::MismatchedBranches disagreeing = core::mismatchedBranches(result, mmPerPx);
    QStringList names;
    for (const int id : disagreeing.branchIds) {
        if (const core::VesselBranch* branch = tree.find(id)) {
            names << displayName(*branch);
        }
    }
    if (names.isEmpty()) {
        return {};
    }
    if (names.size() == 1) {
        return ResultWords::tr("%1 is %2 mm off: possibly unopacified in this frame, or displaced.")
            .arg(names.front(), resultNumber(disagreeing.maxDistanceMm));
    }
    if (names.size() > 3) {
        return ResultWords::tr("%1 branches are up to %2 mm off: unopacified in this frame, or the pose is wrong.")
            .arg(names.size())
            .arg(resultNumber(disagreeing.maxDistanceMm));
    }
    const QString last = names.takeLast();
    return ResultWords::tr("%1 and %2 are up to %3 mm off: possibly unopacified in this frame, or displaced.")
        .arg(joinNames(names), last, resultNumber(disagreeing.maxDistanceMm));
}

}   // namespace

ResultSentences sentencesOf(const core::RegistrationResult& result, const core::VesselTree& tree,
                            double millimetersPerPixel)
{
    ResultSentences sentences;
    const QString pose = certainPose(result.uncertainty);
    const QString branches = agreement(result.branches, millimetersPerPixel);
    const QString likely = likelihood(result);
    if (result.trustworthy) {
        QStringList parts{pose, branches, likely};
        parts.removeAll(QString());
        sentences.certain << joinSentences(parts);
    }
    core::Messages worstFirst = result.warnings;
    std::ranges::stable_partition(worstFirst, [](const core::Message& message) {
        return core::lowersConfidence(message) || message.id().starts_with("patient.");
    });
    for (const core::Message& warning : worstFirst) {
        sentences.doubtful << messageText(warning);
    }
    if (!result.trustworthy && !likely.isEmpty()) {
        sentences.doubtful << likely;
    }
    for (const QString& sentence :
         {depthText(result), geometryText(result.uncertainty), disagreement(result, tree, millimetersPerPixel)}) {
        if (!sentence.isEmpty()) {
            sentences.doubtful << sentence;
        }
    }
    return sentences;
}

std::optional<double> uncertainDepthMm(const core::PoseUncertainty& uncertainty)
{
    const bool isDoubtful =
        !uncertainty.observed[5] || uncertainty.depthMm > 2.0 * std::max(0.5, uncertainty.inPlaneMm);
    return isDoubtful ? std::optional(uncertainty.depthMm) : std::nullopt;
}

QString displayName(const core::VesselBranch& branch)
{
    return branch.name.empty() ? ResultWords::tr("Branch %1").arg(branch.id) : QString::fromStdString(branch.name);
}

}   // namespace angiopose::ui
