#include "core/evaluation/report/published_results.h"
#include "core/evaluation/report/table_parts.h"
#include "core/support/format_number.h"

#include <charconv>
#include <functional>

namespace angiopose::core {
namespace {

/// Returns the number of points of a condition: 44 for "b1-44".
int pointsOf(const Condition& condition)
{
    int points = 0;
    const std::string& id = condition.id;
    std::from_chars(id.data() + id.find('-') + 1, id.data() + id.size(), points);
    return points;
}

std::string cellOf(double closestPx, double angleDeg, double distance)
{
    return fixedText(closestPx, 3) + " / " + fixedText(angleDeg, 3) + " / " + fixedText(distance, 3);
}

std::vector<Condition> conditionsOf(const RunGroups& groups, const std::string& variant)
{
    std::vector<Condition> conditions;
    for (const Condition& condition : groups.conditions()) {
        if (condition.id.starts_with(variant + "-")) {
            conditions.push_back(condition);
        }
    }
    return conditions;
}

ResultTable errorTable(const RunGroups& groups, const std::string& variant, const std::string& title)
{
    const std::vector<Condition> conditions = conditionsOf(groups, variant);
    ResultTable table{"toy-" + variant, "Toy square, " + title + " (mean TRE px / angle ° / Dist)", {"method"}, {}, {}};
    for (const Condition& condition : conditions) {
        table.columns.push_back(std::to_string(pointsOf(condition)) + " points");
    }
    for (std::size_t k = 0; k < groups.methods().size(); ++k) {
        const std::string& method = groups.methods()[k];
        ResultTable::Row row{{method}, false};
        std::vector<std::string> published;
        for (const Condition& condition : conditions) {
            const RunGroup& group = groups.groupOf(condition, method);
            row.cells.push_back(cellOf(group.mean(&RunRecord::closestMedianPx), group.mean(&RunRecord::angleDeg),
                                       group.mean(&RunRecord::seedDistanceMm)));
            if (const auto values = publishedToy(pointsOf(condition), methodIdOf(method))) {
                published.push_back(cellOf(values->closestPx, values->angleDeg, values->seedDistance));
            }
        }
        table.rows.push_back(std::move(row));
        if (!published.empty() && isLastOfMethod(groups.methods(), k)) {
            table.rows.push_back(publishedRow(table, methodIdOf(method), std::move(published)));
        }
    }
    table.notes = {
        "TRE is the median distance to the nearest target point. The published square lies in one plane with "
        "the source; here it is tilted by 30°, which makes its pose observable."};
    return table;
}

/// Fills each column with the number of runs that satisfy `predicate`, such as "3 of 20".
ResultTable countTable(const RunGroups& groups, const std::string& variant, ResultTable table,
                       const std::function<bool(const RunRecord&)>& predicate)
{
    const std::vector<Condition> conditions = conditionsOf(groups, variant);
    table.columns = {"method"};
    for (const Condition& condition : conditions) {
        table.columns.push_back(std::to_string(pointsOf(condition)) + " points");
    }
    for (const std::string& method : groups.methods()) {
        ResultTable::Row row{{method}, false};
        for (const Condition& condition : conditions) {
            const RunGroup& group = groups.groupOf(condition, method);
            row.cells.push_back(std::to_string(group.countIf(predicate)) + " of " + std::to_string(group.count()));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

ResultTable failureTable(const RunGroups& groups, const std::string& variant, const std::string& title)
{
    const SuccessCriterion rule = groups.protocol().success;
    return countTable(groups, variant,
                      {"toy-" + variant + "-failures",
                       "Toy square, " + title + ": failures",
                       {},
                       {},
                       {"Failure: mean distance to the true partners above 1 px."}},
                      [rule](const RunRecord& run) { return !isSuccess(rule, run); });
}

/// Returns tables for the square as printed, which projects onto a single line and does not determine the pose.
std::vector<ResultTable> literalTables(const RunGroups& groups)
{
    const std::string title = "as printed, shift of 1";
    ResultTable errors = errorTable(groups, "a", title);
    errors.notes = {
        "As printed, all corners have y = 0: square and source lie in one plane, and the image is a single line, "
        "partly outside the detector. A shift along that line, the depth and a rotation within the plane move the line "
        "along itself, so distances to the line do not determine them. Only its ends and the positions of the points "
        "on it do; methods that match points with the projections of the tree's own points can use these, but traced "
        "vessels do not provide them. Therefore angle and Dist show what a method made of these positions, and a small "
        "TRE only shows that points lie on the line."};
    return {errors, countTable(groups, "a",
                               {"toy-a-doubted",
                                "Toy square, " + title + ": runs whose pose is rated unreliable",
                                {},
                                {},
                                {"The correct answer is low confidence: the line does not determine the pose. The same "
                                 "criterion rates every method's pose; a run without a result counts as unreliable."}},
                               [](const RunRecord& run) { return run.trustworthy == 0.0; })};
}

}   // namespace

std::vector<ResultTable> toyTables(const RunGroups& groups)
{
    std::vector<ResultTable> tables;
    for (const auto& [variant, title] :
         {std::pair<std::string, std::string>{"b1", "shift of 1"}, {"b2", "shift of 1 and 1° about the source"}}) {
        if (!conditionsOf(groups, variant).empty()) {
            tables.push_back(errorTable(groups, variant, title));
            tables.push_back(failureTable(groups, variant, title));
        }
    }
    if (!conditionsOf(groups, "a").empty()) {
        for (ResultTable& table : literalTables(groups)) {
            tables.push_back(std::move(table));
        }
    }
    return tables;
}

}   // namespace angiopose::core
