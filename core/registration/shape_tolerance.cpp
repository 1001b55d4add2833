#include "core/registration/shape_tolerance.h"

#include "core/support/quantile.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace core {
namespace {

constexpr std::ptrdiff_t stretchPoints = 30;   // 30 mm at the default spacing
constexpr std::ptrdiff_t stretchStep = 5;   // a stretch starts every so many points
constexpr double madToStd = 1.4826;
constexpr int minStretchPoints = 6;
constexpr std::size_t minStretches = 8;
constexpr double exactPx = 0.1;   // smaller offsets are sampling, not shape
constexpr double maxVarianceRatio = 10.0;
constexpr int maxSteps = 10;
constexpr double settledMm = 1e-3;
constexpr double leastDamping = 1e-9;

/// Sums over a stretch of a branch.
struct StretchSums {
    Vector6d gradient = Vector6d::Zero();
    double weight = 0.0;
    double residual = 0.0;
};

/// Calls `visit(from, to)` for overlapping stretches; every row lies in the same number of them.
template <class Visit>
void forEachStretch(const std::vector<ResidualRow>& rows, Visit visit)
{
    const auto count = static_cast<std::ptrdiff_t>(rows.size());
    std::ptrdiff_t branchStart = 0;
    while (branchStart < count) {
        std::ptrdiff_t branchEnd = branchStart + 1;
        while (branchEnd < count && rows[branchEnd].branchIndex == rows[branchStart].branchIndex) {
            ++branchEnd;
        }
        for (std::ptrdiff_t from = branchStart - stretchPoints + stretchStep; from < branchEnd; from += stretchStep) {
            visit(std::max(from, branchStart), std::min(from + stretchPoints, branchEnd));
        }
        branchStart = branchEnd;
    }
}

/// Mean residual of a stretch with enough points, and their deviations from it appended to `deviations`.
std::optional<double> offsetOf(const std::vector<ResidualRow>& rows, std::ptrdiff_t from, std::ptrdiff_t to,
                               std::vector<double>& deviations)
{
    double sum = 0.0;
    int count = 0;
    for (std::ptrdiff_t i = from; i < to; ++i) {
        if (rows[i].weight > 0.0) {
            sum += rows[i].residual;
            ++count;
        }
    }
    if (count < minStretchPoints) {
        return {};
    }
    for (std::ptrdiff_t i = from; i < to; ++i) {
        if (rows[i].weight > 0.0) {
            deviations.push_back(std::abs(rows[i].residual - sum / count));
        }
    }
    return sum / count;
}

/// Step of the shift alone: rows and columns of the turn drop out.
Vector6d shiftStep(NormalEquations equations)
{
    equations.hessian.topRows<3>().setZero();
    equations.hessian.leftCols<3>().setZero();
    equations.gradient.head<3>().setZero();
    return dampedStep(equations, leastDamping);
}

/// Lays the turned tree over the vessels.
CentroidPose settleShift(const Alignment& alignment, const StartPrior& prior, const CentroidPose& pose, double scalePx)
{
    CentroidPose settled = pose;
    for (int k = 0; k < maxSteps; ++k) {
        NormalEquations equations = alignment.look(settled, scalePx).equations;
        prior.add(settled, scalePx * scalePx, equations);
        const Vector6d step = shiftStep(equations);
        settled = moved(settled, step);
        if (step.norm() < settledMm) {
            break;
        }
    }
    return settled;
}

}   // namespace

double offsetVarianceRatio(const std::vector<ResidualRow>& rows)
{
    std::vector<double> offsets;
    std::vector<double> deviations;
    forEachStretch(rows, [&](std::ptrdiff_t from, std::ptrdiff_t to) {
        if (const auto offset = offsetOf(rows, from, to, deviations)) {
            offsets.push_back(std::abs(*offset));
        }
    });
    if (offsets.size() < minStretches) {
        return 0.0;
    }
    const double offsetPx = madToStd * quantile(std::move(offsets), 0.5);
    const double scatterPx = madToStd * quantile(std::move(deviations), 0.5);
    return offsetPx < exactPx ? 0.0 : std::min(maxVarianceRatio, offsetPx * offsetPx / (scatterPx * scatterPx));
}

NormalEquations tolerantEquations(const std::vector<ResidualRow>& rows, double varianceRatio)
{
    NormalEquations equations;
    for (const ResidualRow& row : rows) {
        equations.hessian += row.weight * row.gradient * row.gradient.transpose();
        equations.gradient += row.weight * row.residual * row.gradient;
    }
    const double share = stretchStep / static_cast<double>(stretchPoints);
    forEachStretch(rows, [&](std::ptrdiff_t from, std::ptrdiff_t to) {
        StretchSums sums;
        for (std::ptrdiff_t i = from; i < to; ++i) {
            sums.gradient += rows[i].weight * rows[i].gradient;
            sums.weight += rows[i].weight;
            sums.residual += rows[i].weight * rows[i].residual;
        }
        const double factor = share / (sums.weight + 1.0 / varianceRatio);
        equations.hessian -= factor * sums.gradient * sums.gradient.transpose();
        equations.gradient -= factor * sums.residual * sums.gradient;
    });
    return equations;
}

CentroidPose refineTolerantly(const Alignment& alignment, const StartPrior& prior, const CentroidPose& pose,
                              double scalePx)
{
    std::vector<ResidualRow> rows;
    alignment.collectRows(pose, scalePx, rows);
    const double varianceRatio = offsetVarianceRatio(rows);
    if (varianceRatio == 0.0) {
        return pose;
    }
    CentroidPose refined = pose;
    for (int k = 0; k < maxSteps; ++k) {
        alignment.collectRows(refined, scalePx, rows);
        NormalEquations equations = tolerantEquations(rows, varianceRatio);
        prior.add(refined, scalePx * scalePx, equations);
        const Vector6d step = dampedStep(equations, leastDamping);
        refined = moved(refined, step);
        if (step.tail<3>().norm() < settledMm) {
            break;
        }
    }
    return settleShift(alignment, prior, refined, scalePx);
}

}   // namespace core
