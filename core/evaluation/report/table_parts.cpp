#include "core/evaluation/report/table_parts.h"

#include "core/evaluation/statistics/proportion.h"
#include "core/support/format_number.h"
#include "core/support/quantile.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace angiopose::core {

std::string methodIdOf(const std::string& label)
{
    return label.substr(0, label.find(':'));
}

bool isLastOfMethod(const std::vector<std::string>& labels, std::size_t index)
{
    for (std::size_t k = index + 1; k < labels.size(); ++k) {
        if (methodIdOf(labels[k]) == methodIdOf(labels[index])) {
            return false;
        }
    }
    return true;
}

std::string rateCell(const RunGroup& group, const std::function<bool(const RunRecord&)>& predicate)
{
    if (group.count() == 0) {
        return "–";
    }
    std::map<int, ClusterCount> byTree;
    for (const RunRecord* run : group.runs()) {
        ClusterCount& tree = byTree[run->anatomy];
        tree.successes += predicate(*run) ? 1 : 0;
        ++tree.count;
    }
    std::vector<ClusterCount> trees;
    for (const auto& [anatomy, tree] : byTree) {
        trees.push_back(tree);
    }
    const Interval interval = clusteredInterval(trees);
    return fixedText(100.0 * group.countIf(predicate) / group.count(), 1) + " [" + fixedText(100.0 * interval.low, 1) +
           ", " + fixedText(100.0 * interval.high, 1) + "]";
}

std::string percentCell(int part, int whole)
{
    return whole == 0 ? "–" : fixedText(100.0 * part / whole, 0) + " %";
}

double medianDepthMm(const RunGroup& group)
{
    std::vector<double> depths = group.values(&RunRecord::centroidDepthMm);
    std::transform(depths.begin(), depths.end(), depths.begin(), [](double depth) { return std::abs(depth); });
    return quantile(std::move(depths), 0.5);
}

ResultTable::Row publishedRow(const ResultTable& table, const std::string& label, std::vector<std::string> cells)
{
    cells.insert(cells.begin(), label + ", published");
    cells.resize(table.columns.size(), "–");
    return {std::move(cells), true};
}

}   // namespace angiopose::core
