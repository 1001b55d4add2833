#include "core/evaluation/report/observer_report.h"

#include "core/support/format_number.h"

#include <algorithm>
#include <cctype>
#include <functional>

namespace angiopose::core {
namespace {

using Means = std::vector<ObserverMean>;
using PairVisitor = std::function<void(const std::string& first, const std::string& second, std::size_t measure,
                                       const LimitsOfAgreement& agreement)>;

std::string measureText(std::size_t measure)
{
    const PoseMeasure& row = poseMeasures()[measure];
    return std::string(row.name) + ", " + row.unit;
}

ResultTable repeatabilityTable(const Means& means)
{
    ResultTable table;
    table.id = "observers-within";
    table.title = "Within an observer";
    table.columns = {"observer", "measure", "images", "readings", "SD within", "repeatability coefficient"};
    for (const std::string& observer : observersOf(means)) {
        for (std::size_t measure = 0; measure < poseMeasureCount; ++measure) {
            if (const auto found = repeatabilityOf(means, observer, measure)) {
                table.rows.push_back(
                    {{observer, measureText(measure), std::to_string(found->images), std::to_string(found->readings),
                      fixedText(found->withinStd, 3), fixedText(found->coefficient, 3)},
                     false});
            }
        }
    }
    table.notes = {
        "SD within: SD of repeated readings of the same image, pooled over the images read more than once. "
        "Repeatability coefficient: 1.96 √2 times that SD; two readings differ by less in 95 of 100 cases (Bland and "
        "Altman 1996). Measured about the tree's centroid in the axes of the camera."};
    return table;
}

ResultTable reproducibilityTable(const Means& means)
{
    ResultTable table;
    table.id = "observers-between";
    table.title = "Between observers";
    table.columns = {"measure", "images", "SD between observers"};
    for (std::size_t measure = 0; measure < poseMeasureCount; ++measure) {
        if (const auto found = reproducibilityOf(means, measure)) {
            table.rows.push_back(
                {{measureText(measure), std::to_string(found->images), fixedText(found->betweenStd, 3)}, false});
        }
    }
    table.notes = {
        "Standard deviation of the observers' means within an image, pooled over the images that more than one of them "
        "read. No intraclass correlation is given: a pose has no variance between images to compare with."};
    return table;
}

void forEachPair(const Means& means, const PairVisitor& visitPair)
{
    const std::vector<std::string> observers = observersOf(means);
    for (std::size_t a = 0; a < observers.size(); ++a) {
        for (std::size_t b = a + 1; b < observers.size(); ++b) {
            for (std::size_t measure = 0; measure < poseMeasureCount; ++measure) {
                if (const auto agreement = agreementOf(means, observers[a], observers[b], measure)) {
                    visitPair(observers[a], observers[b], measure, *agreement);
                }
            }
        }
    }
}

std::string withError(double value, double error)
{
    return fixedText(value, 3) + " ± " + fixedText(1.96 * error, 3);
}

ResultTable agreementTable(const Means& means)
{
    ResultTable table;
    table.id = "observers-agreement";
    table.title = "Agreement of two observers (Bland and Altman)";
    table.columns = {"observers", "measure", "images", "bias", "SD", "lower limit", "upper limit"};
    forEachPair(means, [&table](const std::string& first, const std::string& second, std::size_t measure,
                                const LimitsOfAgreement& agreement) {
        table.rows.push_back(
            {{first + " − " + second, measureText(measure), std::to_string(agreement.points.size()),
              withError(agreement.bias, agreement.biasError), fixedText(agreement.stdDeviation, 3),
              withError(agreement.lower(), agreement.limitError), withError(agreement.upper(), agreement.limitError)},
             false});
    });
    table.notes = {
        "Differences of the observers' means in the images that both read. Limits: bias ± 1.96 SD; the value after ± "
        "is half of the 95 % interval (Bland and Altman 1986)."};
    return table;
}

PlotSeries horizontalLine(const std::string& name, double y, const PlotAxis& x)
{
    return {name + " " + fixedText(y, 2), {{x.min, y}, {x.max, y}}, {}};
}

/// Returns an axis that shows all values with a margin.
PlotAxis axisAround(const std::string& label, double low, double high)
{
    const double margin = std::max(0.15 * (high - low), 0.01);
    return {label, low - margin, high + margin, false};
}

std::string fileNamePart(const std::string& text)
{
    std::string word = text;
    std::ranges::replace_if(
        word, [](unsigned char c) { return c < 0x80 && !std::isalnum(c); }, '-');
    return word;
}

Plot agreementPlot(const std::string& first, const std::string& second, std::size_t measure,
                   const LimitsOfAgreement& agreement)
{
    double low = agreement.points.front().x();
    double high = low;
    double lowest = agreement.lower();
    double highest = agreement.upper();
    for (const Eigen::Vector2d& point : agreement.points) {
        low = std::min(low, point.x());
        high = std::max(high, point.x());
        lowest = std::min(lowest, point.y());
        highest = std::max(highest, point.y());
    }
    const std::string text = measureText(measure);
    Plot plot{"observers-" + fileNamePart(first) + "-" + fileNamePart(second) + "-" + poseMeasures()[measure].id,
              first + " and " + second + ": " + text,
              axisAround("mean of both, relative to the pose before the trial: " + text, low, high),
              axisAround(first + " − " + second, lowest, highest),
              {}};
    plot.series = {{"image", agreement.points, {}, true},
                   horizontalLine("bias", agreement.bias, plot.x),
                   horizontalLine("upper limit", agreement.upper(), plot.x),
                   horizontalLine("lower limit", agreement.lower(), plot.x)};
    return plot;
}

}   // namespace

std::vector<ResultTable> observerTables(const std::vector<ObserverReading>& readings)
{
    const Means means = observerMeans(readings);
    std::vector<ResultTable> tables{repeatabilityTable(means), reproducibilityTable(means), agreementTable(means)};
    std::erase_if(tables, [](const ResultTable& table) { return table.rows.empty(); });
    return tables;
}

std::vector<Plot> observerPlots(const std::vector<ObserverReading>& readings)
{
    std::vector<Plot> plots;
    forEachPair(observerMeans(readings), [&plots](const std::string& first, const std::string& second,
                                                  std::size_t measure, const LimitsOfAgreement& agreement) {
        plots.push_back(agreementPlot(first, second, measure, agreement));
    });
    return plots;
}

}   // namespace angiopose::core
