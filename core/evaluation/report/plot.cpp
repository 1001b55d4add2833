#include "core/evaluation/report/plot.h"

#include "core/evaluation/report/run_groups.h"
#include "core/support/quantile.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double minErrorMm = 1e-4;
constexpr double maxErrorMm = 100.0;
constexpr double minErrorPx = 1e-4;
constexpr std::size_t startBins = 8;
constexpr std::size_t minRunsPerBin = 5;

std::string plotId(const RunGroups& groups, const std::string& what, const std::string& condition)
{
    return std::string(groups.protocol().id) + "-" + condition + "-" + what;
}

/// An error measure whose distribution is plotted.
struct PlottedError {
    const char* id;
    const char* label;
    RunValue value;
};
constexpr PlottedError plottedProjectionDistance{"cumulative", "mean projection distance, mm", &RunRecord::meanMm};
constexpr PlottedError plottedRayDistance{"cumulative-mrpd", "distance to the rays (mRPD), mm", &RunRecord::mrpdMm};
constexpr PlottedError plottedTargetError{"cumulative-mtre", "target registration error (mTRE), mm",
                                          &RunRecord::mtreMm};

/// Returns a step function of the error: the percentage of registrations with at most this error.
PlotSeries cumulativeSeries(const std::string& method, const RunGroup& group, RunValue value)
{
    std::vector<double> errors = group.values(value);
    if (errors.empty()) {
        return {method, {}, {}};
    }
    std::sort(errors.begin(), errors.end());
    PlotSeries series{method, {{minErrorMm, 0.0}}, {}};
    for (std::size_t k = 0; k < errors.size(); ++k) {
        const double x = std::clamp(errors[k], minErrorMm, 2.0 * maxErrorMm);
        series.points.emplace_back(x, series.points.back().y());
        series.points.emplace_back(x, 100.0 * static_cast<double>(k + 1) / static_cast<double>(errors.size()));
    }
    series.points.emplace_back(2.0 * maxErrorMm, series.points.back().y());
    return series;
}

Plot cumulativePlot(const RunGroups& groups, const Condition& condition, const PlottedError& error)
{
    Plot plot{plotId(groups, error.id, condition.id),
              condition.title,
              {error.label, minErrorMm, maxErrorMm, true},
              {"registrations at or below, %", 0.0, 100.0, false},
              {}};
    for (const std::string& method : groups.methods()) {
        if (groups.groupOf(condition, method).count() > 0) {
            plot.series.push_back(cumulativeSeries(method, groups.groupOf(condition, method), error.value));
        }
    }
    return plot;
}

void addRate(const Protocol& protocol, const RunGroup& group, PlotSeries& series)
{
    const int successes = group.countIf([&](const RunRecord& run) { return isSuccess(protocol.success, run); });
    const Interval interval = wilsonInterval(successes, group.count());
    series.points.emplace_back(group.mean(&RunRecord::startMtreMm), 100.0 * successes / group.count());
    series.bands.push_back({100.0 * interval.low, 100.0 * interval.high});
}

/// Returns the success rate with its interval for each nonempty bin, over the mean initial mTRE of the bin.
PlotSeries successSeries(const Protocol& protocol, const std::string& method, const std::vector<RunGroup>& bins)
{
    PlotSeries series{method, {}, {}};
    for (const RunGroup& bin : bins) {
        if (bin.count() > 0) {
            addRate(protocol, bin, series);
        }
    }
    return series;
}

std::vector<RunGroup> equalBins(const RunGroup& group)
{
    std::vector<double> fractions;
    for (std::size_t k = 0; k <= startBins; ++k) {
        fractions.push_back(static_cast<double>(k) / startBins);
    }
    const std::vector<double> edges = quantiles(group.values(&RunRecord::startMtreMm), fractions);
    std::vector<RunGroup> bins;
    for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
        const bool isLast = k + 2 == edges.size();
        bins.push_back(group.filter([&](const RunRecord& run) {
            return run.startMtreMm >= edges[k] && (run.startMtreMm < edges[k + 1] || isLast);
        }));
    }
    return bins;
}

double maxInitialErrorMm(const Plot& plot)
{
    double largest = 0.0;
    for (const PlotSeries& series : plot.series) {
        for (const Eigen::Vector2d& point : series.points) {
            largest = std::max(largest, point.x());
        }
    }
    return largest;
}

Plot emptySuccessPlot(const RunGroups& groups, const std::string& id, const std::string& title)
{
    return {plotId(groups, "success", id),
            title,
            {"mean target error of the initial pose, mm", 0.0, 1.0, false},
            {"success rate, %", 0.0, 100.0, false},
            {}};
}

Plot successPlot(const RunGroups& groups, const Condition& condition)
{
    Plot plot = emptySuccessPlot(groups, condition.id, condition.title);
    for (const std::string& method : groups.methods()) {
        const RunGroup& group = groups.groupOf(condition, method);
        const std::vector<double> starts = group.values(&RunRecord::startMtreMm);
        const auto [lowest, highest] = std::minmax_element(starts.begin(), starts.end());
        if (starts.size() >= startBins * minRunsPerBin && *highest > 1.01 * *lowest) {
            plot.series.push_back(successSeries(groups.protocol(), method, equalBins(group)));
        }
    }
    plot.x.max = 1.05 * maxInitialErrorMm(plot);
    return plot;
}

/// Returns a plot of the success rate over all bins of the capture range for one kind of target.
Plot capturePlot(const RunGroups& groups, const std::string& target, const std::string& title)
{
    Plot plot = emptySuccessPlot(groups, target, title);
    for (const std::string& method : groups.methods()) {
        std::vector<RunGroup> bins;
        for (const Condition& condition : groups.conditions()) {
            if (condition.id.starts_with(target + "-")) {
                bins.push_back(groups.groupOf(condition, method));
            }
        }
        plot.series.push_back(successSeries(groups.protocol(), method, bins));
    }
    plot.x.max = 1.05 * maxInitialErrorMm(plot);
    return plot;
}

/// Returns the median error over the runs at each progress report; a finished run keeps its last value.
PlotSeries convergenceSeries(const std::string& method, const RunGroup& group)
{
    std::size_t longest = 0;
    std::vector<const std::vector<double>*> histories;
    for (const RunRecord* run : group.runs()) {
        if (!run->history.empty()) {
            histories.push_back(&run->history);
            longest = std::max(longest, run->history.size());
        }
    }
    PlotSeries series{method, {}, {}};
    for (std::size_t report = 0; report < longest; ++report) {
        std::vector<double> values;
        values.reserve(histories.size());
        for (const std::vector<double>* history : histories) {
            values.push_back((*history)[std::min(report, history->size() - 1)]);
        }
        const double median = quantile(std::move(values), 0.5);
        series.points.emplace_back(static_cast<double>(report + 1), std::max(median, minErrorPx));
    }
    return series;
}

Plot convergencePlot(const RunGroups& groups, const Condition& condition)
{
    Plot plot{plotId(groups, "convergence", condition.id),
              condition.title,
              {"iteration", 1.0, 10.0, true},
              {"median projection distance, px", minErrorPx, 10.0, true},
              {}};
    for (const std::string& method : groups.methods()) {
        PlotSeries series = convergenceSeries(method, groups.groupOf(condition, method));
        for (const Eigen::Vector2d& point : series.points) {
            plot.x.max = std::max(plot.x.max, point.x());
            plot.y.max = std::max(plot.y.max, std::isfinite(point.y()) ? 1.5 * point.y() : 0.0);
        }
        if (!series.points.empty()) {
            plot.series.push_back(std::move(series));
        }
    }
    return plot;
}

}   // namespace

std::vector<Plot> makePlots(const RunSet& runs)
{
    const RunGroups groups(runs);
    std::vector<Plot> plots;
    if (groups.protocol().id == "capture-range") {
        plots = {capturePlot(groups, "clean", "resampled curves"), capturePlot(groups, "degraded", "degraded target")};
    } else {
        for (const Condition& condition : groups.conditions()) {
            plots.push_back(cumulativePlot(groups, condition, plottedProjectionDistance));
            if (groups.protocol().id == "own") {
                plots.push_back(cumulativePlot(groups, condition, plottedRayDistance));
                plots.push_back(cumulativePlot(groups, condition, plottedTargetError));
            }
            plots.push_back(successPlot(groups, condition));
            plots.push_back(convergencePlot(groups, condition));
        }
    }
    std::erase_if(plots, [](const Plot& plot) {
        return std::all_of(plot.series.begin(), plot.series.end(),
                           [](const PlotSeries& series) { return series.points.empty(); });
    });
    return plots;
}

}   // namespace angiopose::core
