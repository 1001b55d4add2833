#include "core/registration/alignment/agreement_score.h"

#include "core/registration/alignment/alignment_points.h"
#include "core/support/cell_index.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double toleranceScalePx = 2.0;   // Welsch scale at which hypotheses are compared (ALGORITHMS §6.8)
constexpr std::size_t pointStride = 2;
constexpr std::size_t maxPoints = 4000;
constexpr int agreementCellPx = 3;

// Parameters of the agreement score for a partly opacified tree.
constexpr double minSegmentAgreement =
    0.35;   // segments with lower agreement count as unopacified: chance yields 0.1, true matches 0.6 to 1
constexpr double changeCostMm =
    6.0;   // vessel length needed as evidence before a segment's state may differ from its neighbors
constexpr double minTerritoryMm = 15.0;
constexpr double costOfTerritory = 0.02;

/// Returns the fraction of the tree points that lie along traced vessels.
double shareOn(const Alignment& alignment, const CentroidPose& pose)
{
    const double missing = alignment.loss(pose, toleranceScalePx) / (2.0 * toleranceScalePx * toleranceScalePx);
    return 1.0 - missing / static_cast<double>(alignment.size());
}

double harmonicMean(double a, double b)
{
    return a + b > 0.0 ? 2.0 * a * b / (a + b) : 0.0;
}

}   // namespace

AgreementScore::AgreementScore(const RegistrationProblem& problem, const TargetLines& target)
    : tree_(problem.tree),
      stride_(std::max(pointStride, strideFor(problem.tree.size(), maxPoints))),
      points_(alignmentPoints(problem.tree, stride_)),
      camera_(problem.camera),
      target_(&target),
      lineStride_(strideFor(target.lines().size(), maxPoints)),
      fullAlignment_(points_, camera_, target),
      columns_(camera_.width / agreementCellPx + 1),
      rows_(camera_.height / agreementCellPx + 1)
{
    if (problem.hasUserAuxiliary) {
        auxiliaryAlignment_.emplace(alignmentPoints(problem.tree, problem.auxiliary), camera_, target);
    }
    covered_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
}

double AgreementScore::scoreAt(const CentroidPose& pose)
{
    resetCoverage();
    for (const AlignmentPoint& point : points_) {
        markCovered(point, pose);
    }
    return harmonicMean(treeFraction(pose), coveredTargetFraction());
}

const OpacificationModel& AgreementScore::opacification()
{
    if (!opacification_) {
        opacification_.emplace(tree_);
        for (std::size_t i = stride_ / 2; i < tree_.size(); i += stride_) {
            segmentOfPoint_.push_back(opacification_->segmentOfPoint()[i]);
        }
    }
    return *opacification_;
}

OpacifiedAgreement AgreementScore::scoreOpacified(const CentroidPose& pose)
{
    const OpacificationModel& opacification = this->opacification();
    fullAlignment_.collectAgreement(pose, toleranceScalePx, pointAgreement_);
    std::vector<double> gain(opacification.pieces().size(), 0.0);
    std::vector<double> count(opacification.pieces().size(), 0.0);
    for (std::size_t k = 0; k < points_.size(); ++k) {
        const auto piece = static_cast<std::size_t>(segmentOfPoint_[k]);
        count[piece] += 1.0;
        gain[piece] += std::isnan(pointAgreement_[k]) ? 0.0 : pointAgreement_[k] - minSegmentAgreement;
    }
    for (std::size_t piece = 0; piece < gain.size(); ++piece) {
        gain[piece] *= opacification.lengthMm(piece) / std::max(1.0, count[piece]);
    }
    OpacifiedAgreement result;
    result.isOpacified = opacification.likeliestStates(gain, changeCostMm);
    double agreeing = 0.0;
    double tested = 0.0;
    resetCoverage();
    for (std::size_t k = 0; k < points_.size(); ++k) {
        if (result.isOpacified[static_cast<std::size_t>(segmentOfPoint_[k])] != 0) {
            agreeing += std::isnan(pointAgreement_[k]) ? 0.0 : pointAgreement_[k];
            tested += 1.0;
            markCovered(points_[k], pose);
        }
    }
    const int territories = opacification.countUnopacifiedTerritories(result.isOpacified, minTerritoryMm);
    double treeFraction = agreeing / std::max(1.0, tested);
    if (auxiliaryAlignment_) {
        treeFraction = std::min(
            treeFraction, shareOn(*auxiliaryAlignment_, pose));   // the user has marked these branches as opacified
    }
    result.agreement = harmonicMean(treeFraction, coveredTargetFraction()) / (1.0 + costOfTerritory * territories);
    return result;
}

double AgreementScore::treeFraction(const CentroidPose& pose)
{
    const double all = shareOn(fullAlignment_, pose);
    return auxiliaryAlignment_ ? 0.5 * (all + shareOn(*auxiliaryAlignment_, pose)) : all;
}

void AgreementScore::resetCoverage()
{
    std::fill(covered_.begin(), covered_.end(), std::uint8_t{0});
}

void AgreementScore::markCovered(const AlignmentPoint& point, const CentroidPose& pose)
{
    const auto pixel = project(camera_, pose.rotation * point.fromCentroid + pose.centroidInCamera);
    if (!pixel) {
        return;
    }
    const Eigen::Vector2d cell = pixel->array() / agreementCellPx;
    if (!(cell.minCoeff() >= 1.0 && cell.x() < columns_ - 2.0 && cell.y() < rows_ - 2.0)) {
        return;
    }
    std::uint8_t* center = &covered_[cellIndex(static_cast<int>(cell.y()), columns_, static_cast<int>(cell.x()))];
    for (int row = -1; row <= 1; ++row) {
        std::fill_n(center + static_cast<std::ptrdiff_t>(row) * columns_ - 1, 3, std::uint8_t{1});
    }
}

double AgreementScore::coveredTargetFraction() const
{
    std::size_t hits = 0;
    const auto& lines = target_->lines();
    for (std::size_t i = 0; i < lines.size(); i += lineStride_) {
        const TargetLines::Line& line = lines[i];
        const int column = std::clamp(static_cast<int>(line.x / agreementCellPx), 0, columns_ - 1);
        const int row = std::clamp(static_cast<int>(line.y / agreementCellPx), 0, rows_ - 1);
        hits += covered_[cellIndex(row, columns_, column)];
    }
    const std::size_t tested = (lines.size() + lineStride_ - 1) / lineStride_;
    return static_cast<double>(hits) / static_cast<double>(tested);
}

}   // namespace angiopose::core
