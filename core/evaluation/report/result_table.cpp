#include "core/evaluation/report/result_table.h"

#include "core/evaluation/report/table_parts.h"

#include <map>

namespace angiopose::core {

std::vector<ResultTable> makeTables(const RunSet& runs)
{
    using Layout = std::vector<ResultTable> (*)(const RunGroups&);
    static const std::map<std::string_view, Layout> errorLayouts{{"toy", toyTables},
                                                                 {"simulation", simulationTables},
                                                                 {"robustness", robustnessTables},
                                                                 {"clinical", clinicalTables},
                                                                 {"capture-range", captureRangeTables},
                                                                 {"trust", confidenceTables},
                                                                 {"own", ownTables}};
    const RunGroups groups(runs);
    std::vector<ResultTable> tables;
    for (const Layout layout : {errorLayouts.at(groups.protocol().id), Layout(statisticsTables), Layout(ablationTables),
                                Layout(timeTables)}) {
        for (ResultTable& table : layout(groups)) {
            tables.push_back(std::move(table));
        }
    }
    return tables;
}

}   // namespace angiopose::core
