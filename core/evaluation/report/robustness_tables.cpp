#include "core/evaluation/report/published_results.h"
#include "core/evaluation/report/table_parts.h"
#include "core/support/format_number.h"
#include "core/support/quantile.h"

#include <cmath>

namespace angiopose::core {
namespace {

struct Medians {
    double closestPx = 0.0;
    double angleDeg = 0.0;
    double seedDistanceMm = 0.0;
};

std::string cellOf(const Medians& medians)
{
    return fixedText(medians.closestPx, 3) + " / " + fixedText(medians.angleDeg, 3) + " / " +
           fixedText(medians.seedDistanceMm, 2);
}

double centroidMm(const RunRecord& run)
{
    return std::hypot(run.centroidInPlaneMm, run.centroidDepthMm);
}

std::vector<std::string> cellsOf(const std::string& method, const RunGroup& group, int anatomyCount)
{
    std::vector<std::string> cells{method};
    Medians mean;
    for (int anatomy = 0; anatomy < anatomyCount; ++anatomy) {
        const RunGroup part = group.forAnatomy(anatomy);
        const Medians medians{part.median(&RunRecord::closestMedianPx), part.median(&RunRecord::angleDeg),
                              part.median(&RunRecord::seedDistanceMm)};
        cells.push_back(cellOf(medians));
        mean.closestPx += medians.closestPx / anatomyCount;
        mean.angleDeg += medians.angleDeg / anatomyCount;
        mean.seedDistanceMm += medians.seedDistanceMm / anatomyCount;
    }
    cells.push_back(cellOf(mean));
    std::vector<double> centroidErrors;
    for (const RunRecord* run : group.runs()) {
        centroidErrors.push_back(centroidMm(*run));
    }
    const std::vector<double> shares = quantiles(centroidErrors, {0.5, 0.95});
    cells.push_back(fixedText(shares[0], 3) + " / " + fixedText(shares[1], 3));
    cells.push_back(fixedText(group.median(&RunRecord::centroidInPlaneMm), 3));
    cells.push_back(fixedText(medianDepthMm(group), 3));
    cells.push_back(fixedText(group.quantile(&RunRecord::angleDeg, 0.95), 3));
    cells.push_back(rateCell(group, isGrossFailurePx));
    return cells;
}

ResultTable robustnessTable(const RunGroups& groups, const Condition& condition)
{
    const int anatomyCount = groups.anatomyCount();
    ResultTable table;
    table.id = "robustness-" + condition.id;
    table.title = "Robustness: " + condition.title + " (median TRE px / angle ° / Dist mm)";
    table.columns = {"method"};
    for (int anatomy = 1; anatomy <= anatomyCount; ++anatomy) {
        table.columns.push_back("P" + std::to_string(anatomy));
    }
    for (const char* column :
         {"mean", "centroid mm, median / p95", "in plane mm", "depth mm", "angle ° p95", "GFR %"}) {
        table.columns.emplace_back(column);
    }
    for (std::size_t k = 0; k < groups.methods().size(); ++k) {
        const std::string& method = groups.methods()[k];
        if (groups.groupOf(condition, method).count() == 0) {
            continue;
        }
        table.rows.push_back({cellsOf(method, groups.groupOf(condition, method), anatomyCount), false});
        const auto published = publishedRobustness(condition.id, methodIdOf(method));
        if (published && isLastOfMethod(groups.methods(), k)) {
            std::vector<std::string> cells(static_cast<std::size_t>(anatomyCount), "–");
            cells.push_back(cellOf({published->closestMedianPx, published->angleDeg, published->seedDistanceMm}));
            table.rows.push_back(publishedRow(table, methodIdOf(method), std::move(cells)));
        }
    }
    table.notes = {
        "P1 to P6: medians over the trials of one tree; mean: over the trees. TRE is the distance of a projected tree "
        "point to the nearest target point, Dist the shift of the camera-frame origin; the error of the centroid does "
        "not depend on that origin.",
        "GFR: share of registrations whose points are more than 5 px from their true partners on average, with its 95 "
        "% interval from resampling trees with all their trials."};
    if (publishedRobustness(condition.id, "nicp")) {
        table.notes.emplace_back(
            "Where Dist equals the displacement, the shift was never corrected: iterative-pnp is constrained by its "
            "prior, which adds radians and millimeters; the published NICP by its step (nicp:literal), while nicp "
            "weights rotations and shifts equally. dynaweight and nicp-alternating free the shift in their auxiliary "
            "problem and use up to five rounds, more than the published figures show.");
    }
    return table;
}

}   // namespace

std::vector<ResultTable> robustnessTables(const RunGroups& groups)
{
    std::vector<ResultTable> tables;
    for (const Condition& condition : groups.conditions()) {
        tables.push_back(robustnessTable(groups, condition));
    }
    return tables;
}

}   // namespace angiopose::core
