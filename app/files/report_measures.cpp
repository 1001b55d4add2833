#include "app/files/report_measures.h"

#include "app/words/measure_words.h"

namespace angiopose::app {
ReportRows measuredRows(const core::Case& theCase)
{
    const core::View& view = theCase.shown();
    ReportRows rows;
    for (const core::ImageMeasurement& measurement : view.measurements) {
        const ui::MeasureRow row = measureRow(measurement, {view, theCase.vessels.tree.get()});
        rows.emplace_back(row.name, row.value + QStringLiteral(" · ") + row.basis);
    }
    return rows;
}

}   // namespace angiopose::app
