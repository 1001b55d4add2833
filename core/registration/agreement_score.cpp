#include "core/registration/agreement_score.h"

#include <algorithm>

namespace core {
namespace {

constexpr double toleranceScalePx = 2.0;   // ALGORITHMS §6.8: hypotheses are compared at this scale
constexpr int cellPx = 2;

}   // namespace

AgreementScore::AgreementScore(const TreeSamples& tree, const ProjectionCamera& camera, const TargetLines& target)
    : points_(alignmentPoints(tree)),
      camera_(camera),
      target_(&target),
      alignment_(points_, camera, target),
      columns_(camera.width / cellPx + 1),
      rows_(camera.height / cellPx + 1)
{
    covered_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
}

double AgreementScore::of(const CentroidPose& pose)
{
    const double missing = alignment_.look(pose, toleranceScalePx).loss / (2.0 * toleranceScalePx * toleranceScalePx);
    const double treeShare = 1.0 - missing / static_cast<double>(points_.size());
    const double targetShare = coveredTargetShare(pose);
    const double sum = treeShare + targetShare;
    return sum > 0.0 ? 2.0 * treeShare * targetShare / sum : 0.0;
}

double AgreementScore::coveredTargetShare(const CentroidPose& pose)
{
    std::fill(covered_.begin(), covered_.end(), std::uint8_t{0});
    for (const AlignmentPoint& point : points_) {
        const auto pixel = project(camera_, pose.rotation * point.fromCentroid + pose.centroidInCamera);
        if (!pixel) {
            continue;
        }
        const Eigen::Vector2d cell = pixel->array() / cellPx;
        if (!(cell.minCoeff() >= 1.0 && cell.x() < columns_ - 2.0 && cell.y() < rows_ - 2.0)) {
            continue;
        }
        std::uint8_t* centre =
            &covered_[static_cast<std::size_t>(static_cast<int>(cell.y()) * columns_ + static_cast<int>(cell.x()))];
        for (int row = -1; row <= 1; ++row) {
            std::fill_n(centre + row * columns_ - 1, 3, std::uint8_t{1});
        }
    }
    std::size_t hits = 0;
    for (const TargetLines::Line& line : target_->lines()) {
        const int column = std::clamp(static_cast<int>(line.x / cellPx), 0, columns_ - 1);
        const int row = std::clamp(static_cast<int>(line.y / cellPx), 0, rows_ - 1);
        hits += covered_[static_cast<std::size_t>(row * columns_ + column)];
    }
    return static_cast<double>(hits) / static_cast<double>(target_->lines().size());
}

}   // namespace core
