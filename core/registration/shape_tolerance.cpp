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
constexpr double minScatterPx = 0.02;   // sampling of the curves: no fit is better than this
constexpr double noMatchPx = 6.0;   // scatter to assume where next to nothing matches
constexpr std::size_t maxLag = 20;
constexpr double insignificantCorrelation = 0.05;
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

/// Mean residual of the matched points of a stretch; nothing when they are few.
std::optional<double> offsetOf(const std::vector<ResidualRow>& rows, std::ptrdiff_t from, std::ptrdiff_t to)
{
    double sum = 0.0;
    int count = 0;
    for (std::ptrdiff_t i = from; i < to; ++i) {
        if (rows[i].weight > 0.0) {
            sum += rows[i].residual;
            ++count;
        }
    }
    return count < minStretchPoints ? std::nullopt : std::optional(sum / count);
}

double robustStd(std::vector<double> values)
{
    for (double& value : values) {
        value = std::abs(value);
    }
    return madToStd * quantile(std::move(values), 0.5);
}

/// Offsets of the stretches, and every residual without the offset of a stretch around it.
struct Decomposition {
    std::vector<double> offsets;
    std::vector<double> scatter;   ///< one per row; NaN where unmatched
};

Decomposition decompose(const std::vector<ResidualRow>& rows)
{
    Decomposition result;
    result.scatter.assign(rows.size(), std::numeric_limits<double>::quiet_NaN());
    forEachStretch(rows, [&](std::ptrdiff_t from, std::ptrdiff_t to) {
        const auto offset = offsetOf(rows, from, to);
        if (!offset) {
            return;
        }
        result.offsets.push_back(*offset);
        for (std::ptrdiff_t i = from; i < to; ++i) {
            if (rows[i].weight > 0.0) {
                result.scatter[static_cast<std::size_t>(i)] = rows[i].residual - *offset;
            }
        }
    });
    return result;
}

/// 1 + 2 Σ ρ_k up to the first lag that no longer correlates.
double correlationPoints(const std::vector<ResidualRow>& rows, const std::vector<double>& scatter)
{
    const auto meanProduct = [&](std::size_t lag) {
        double sum = 0.0;
        int count = 0;
        for (std::size_t i = lag; i < scatter.size(); ++i) {
            const double product = scatter[i] * scatter[i - lag];
            if (rows[i].branchIndex == rows[i - lag].branchIndex && std::isfinite(product)) {
                sum += product;
                ++count;
            }
        }
        return count > 0 ? sum / count : 0.0;
    };
    const double variance = meanProduct(0);
    double length = 1.0;
    for (std::size_t lag = 1; lag <= maxLag && variance > 0.0; ++lag) {
        const double correlation = meanProduct(lag) / variance;
        if (correlation < insignificantCorrelation) {
            break;
        }
        length += 2.0 * correlation;
    }
    return length;
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
        prior.add(settled, noiseVariance(scalePx), equations);
        const Vector6d step = shiftStep(equations);
        settled = moved(settled, step);
        if (step.norm() < settledMm) {
            break;
        }
    }
    return settled;
}

}   // namespace

double ShapeErrors::varianceRatio() const
{
    const double ratio = offsetPx * offsetPx / (scatterPx * scatterPx);
    return offsetPx < exactPx ? 0.0 : std::min(maxVarianceRatio, ratio);
}

ShapeErrors shapeErrors(const std::vector<ResidualRow>& rows)
{
    Decomposition parts = decompose(rows);
    ShapeErrors errors;
    errors.correlationPoints = correlationPoints(rows, parts.scatter);
    std::erase_if(parts.scatter, [](double value) { return std::isnan(value); });
    if (parts.offsets.size() < minStretches) {
        errors.scatterPx = noMatchPx;
        return errors;
    }
    errors.scatterPx = std::max(minScatterPx, robustStd(std::move(parts.scatter)));
    // A mean of correlated scatter is not zero either.
    const double byScatter =
        errors.scatterPx * errors.scatterPx * errors.correlationPoints / static_cast<double>(stretchPoints);
    const double offset = robustStd(std::move(parts.offsets));
    errors.offsetPx = std::sqrt(std::max(0.0, offset * offset - byScatter));
    return errors;
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
    const double varianceRatio = shapeErrors(rows).varianceRatio();
    if (varianceRatio == 0.0) {
        return pose;
    }
    CentroidPose refined = pose;
    for (int k = 0; k < maxSteps; ++k) {
        alignment.collectRows(refined, scalePx, rows);
        NormalEquations equations = tolerantEquations(rows, varianceRatio);
        prior.add(refined, noiseVariance(scalePx), equations);
        const Vector6d step = dampedStep(equations, leastDamping);
        refined = moved(refined, step);
        if (step.tail<3>().norm() < settledMm) {
            break;
        }
    }
    return settleShift(alignment, prior, refined, scalePx);
}

}   // namespace core
