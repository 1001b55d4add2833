#include "core/registration/alignment/residual_noise.h"

#include "core/support/quantile.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace angiopose::core {
namespace {

constexpr int stretchPoints = 30;   // number of points of a stretch; 30 mm at the default spacing
constexpr int stretchStep = 5;   // number of points between the starts of successive stretches
constexpr double residualMadToStd = 1.4826;
constexpr int minStretchPoints = 6;
constexpr std::size_t minStretches = 8;
constexpr double minScatterPx = 0.02;   // sampling error of the curves, a lower limit for any fit
constexpr double unmatchedScatterPx = 6.0;   // scatter assumed if hardly any point matches
constexpr std::size_t maxLag = 20;
constexpr double insignificantCorrelation = 0.05;

/// Calls `visit(from, to)` for overlapping stretches that cover every row equally often.
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

/// Returns the mean residual of the matched points of a stretch; nullopt if too few points match.
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
    return residualMadToStd * quantile(std::move(values), 0.5);
}

/// Mean offsets of the stretches, and the residuals that remain after subtracting them.
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

/// Returns the autocovariance of the scatter between points of one branch, from lag 0 to the first uncorrelated lag.
std::vector<double> autocovariance(const std::vector<ResidualRow>& rows, const std::vector<double>& scatter)
{
    std::vector<double> products;
    for (std::size_t lag = 0; lag <= maxLag; ++lag) {
        double sum = 0.0;
        int count = 0;
        for (std::size_t i = lag; i < scatter.size(); ++i) {
            const double product = scatter[i] * scatter[i - lag];
            if (rows[i].branchIndex == rows[i - lag].branchIndex && std::isfinite(product)) {
                sum += product;
                ++count;
            }
        }
        products.push_back(count > 0 ? sum / count : 0.0);
        if (products.back() <= insignificantCorrelation * products.front()) {
            break;
        }
    }
    return products;
}

struct Correlation {
    double points = 1.0;   ///< correlation length in points, 1 + 2 Σ ρ_k
    double inflation = 1.0;   ///< true variance of the scatter divided by the variance within stretches
};

/// Returns the correlation of the scatter. Adds back the variance s² l_c / n that subtracting a stretch's mean removes.
Correlation correlationOf(const std::vector<double>& autocovariance)
{
    Correlation correlation;
    double takenAway = 0.0;
    for (int round = 0; round < 3 && autocovariance.front() > 0.0; ++round) {
        const double variance = autocovariance.front() + takenAway;
        correlation = {1.0, variance / autocovariance.front()};
        for (std::size_t lag = 1; lag + 1 < autocovariance.size(); ++lag) {
            correlation.points += 2.0 * (autocovariance[lag] + takenAway) / variance;
        }
        takenAway = std::min(autocovariance.front(), variance * correlation.points / stretchPoints);
    }
    return correlation;
}

}   // namespace

ResidualNoise residualNoise(const std::vector<ResidualRow>& rows)
{
    Decomposition parts = decompose(rows);
    ResidualNoise noise;
    const Correlation correlation = correlationOf(autocovariance(rows, parts.scatter));
    noise.correlationPoints = correlation.points;
    std::erase_if(parts.scatter, [](double value) { return std::isnan(value); });
    if (parts.offsets.size() < minStretches) {
        noise.scatterPx = unmatchedScatterPx;
        return noise;
    }
    noise.scatterPx = std::max(minScatterPx, std::sqrt(correlation.inflation) * robustStd(std::move(parts.scatter)));
    // Correlated scatter alone also yields nonzero mean offsets, whose variance is subtracted here.
    const double byScatter = noise.scatterPx * noise.scatterPx * noise.correlationPoints / stretchPoints;
    const double offset = robustStd(std::move(parts.offsets));
    noise.offsetPx = std::sqrt(std::max(0.0, offset * offset - byScatter));
    return noise;
}

}   // namespace angiopose::core
