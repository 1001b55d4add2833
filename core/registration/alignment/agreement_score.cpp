#include "core/registration/alignment/agreement_score.h"

#include "core/support/cell_index.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double toleranceScalePx = 2.0;   // ALGORITHMS §6.8: hypotheses are compared at this scale
constexpr std::size_t pointStride = 2;
constexpr std::size_t mostPoints = 4000;
constexpr int agreementCellPx = 3;

}   // namespace

AgreementScore::AgreementScore(const RegistrationProblem& problem, const TargetLines& target)
    : points_(alignmentPoints(problem.tree, std::max(pointStride, strideFor(problem.tree.size(), mostPoints)))),
      camera_(problem.camera),
      target_(&target),
      lineStride_(strideFor(target.lines().size(), mostPoints)),
      all_(points_, camera_, target),
      columns_(camera_.width / agreementCellPx + 1),
      rows_(camera_.height / agreementCellPx + 1)
{
    if (problem.auxiliaryIsChosen) {
        chosen_.emplace(alignmentPoints(problem.tree, problem.auxiliary), camera_, target);
    }
    covered_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
}

double AgreementScore::of(const CentroidPose& pose)
{
    const double tree = treeShare(pose);
    const double target = coveredTargetShare(pose);
    return tree + target > 0.0 ? 2.0 * tree * target / (tree + target) : 0.0;
}

double AgreementScore::treeShare(const CentroidPose& pose)
{
    const auto share = [&](const Alignment& alignment) {
        const double missing = alignment.loss(pose, toleranceScalePx) / (2.0 * toleranceScalePx * toleranceScalePx);
        return 1.0 - missing / static_cast<double>(alignment.size());
    };
    return chosen_ ? 0.5 * (share(all_) + share(*chosen_)) : share(all_);
}

double AgreementScore::coveredTargetShare(const CentroidPose& pose)
{
    std::fill(covered_.begin(), covered_.end(), std::uint8_t{0});
    for (const AlignmentPoint& point : points_) {
        const auto pixel = project(camera_, pose.rotation * point.fromCentroid + pose.centroidInCamera);
        if (!pixel) {
            continue;
        }
        const Eigen::Vector2d cell = pixel->array() / agreementCellPx;
        if (!(cell.minCoeff() >= 1.0 && cell.x() < columns_ - 2.0 && cell.y() < rows_ - 2.0)) {
            continue;
        }
        std::uint8_t* centre = &covered_[cellIndex(static_cast<int>(cell.y()), columns_, static_cast<int>(cell.x()))];
        for (int row = -1; row <= 1; ++row) {
            std::fill_n(centre + static_cast<std::ptrdiff_t>(row) * columns_ - 1, 3, std::uint8_t{1});
        }
    }
    std::size_t hits = 0;
    const auto& lines = target_->lines();
    for (std::size_t i = 0; i < lines.size(); i += lineStride_) {
        const TargetLines::Line& line = lines[i];
        const int column = std::clamp(static_cast<int>(line.x / agreementCellPx), 0, columns_ - 1);
        const int row = std::clamp(static_cast<int>(line.y / agreementCellPx), 0, rows_ - 1);
        hits += covered_[cellIndex(row, columns_, column)];
    }
    const std::size_t asked = (lines.size() + lineStride_ - 1) / lineStride_;
    return static_cast<double>(hits) / static_cast<double>(asked);
}

}   // namespace angiopose::core