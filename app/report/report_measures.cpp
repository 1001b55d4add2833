#include "app/report/report_measures.h"

#include "app/report/page_words.h"
#include "app/words/mark_words.h"
#include "app/words/measure_words.h"
#include "core/measuring/branch_profile.h"
#include "ui/words/number.h"

namespace angiopose::app {
namespace {

using report::PageWords;

/// Smaller diameter reductions are within the measurement error and are not reported as a stenosis.
constexpr double minStenosisPercent = 10.0;

}   // namespace

ReportRows measurementRows(const core::Case& session)
{
    const core::View& view = session.shown();
    ReportRows rows;
    for (const core::ImageMeasurement& measurement : view.measurements) {
        const ui::MeasureRow row = measureRow(measurement, {view, session.vessels.tree.get()});
        rows.emplace_back(row.name, row.value + QStringLiteral(" · ") + row.basis);
    }
    const auto& scan = session.vessels.scan;
    for (const core::SliceMeasurement& measurement : session.vessels.measurements) {
        const ui::MeasureRow row = sliceRow(measurement, scan ? &scan->geometry : nullptr);
        rows.emplace_back(row.name, row.value + QStringLiteral(" · ") + row.basis);
    }
    return rows;
}

ReportRows targetPointRows(const core::Case& session)
{
    const auto checked = core::evaluateTargetPoints(session);
    ReportRows rows;
    for (const core::VesselMark& mark : session.vessels.marks) {
        const ui::MarkRow row = markRow(mark, checked, session.shownView);
        rows.emplace_back(row.name, row.value + QStringLiteral(" · ") + row.basis);
    }
    return rows;
}

QString diameterText(const core::VesselBranch& branch)
{
    const auto profile = core::measureProfile(branch);
    if (!profile || !profile.value().meanDiameterMm) {
        return {};
    }
    const core::BranchProfile& along = profile.value();
    const QString mean = QStringLiteral(" · ⌀ %1 mm").arg(ui::numberText(*along.meanDiameterMm, 1));
    const bool isNarrowed = along.stenosis && along.stenosis->percent >= minStenosisPercent;
    return isNarrowed ? mean + PageWords::tr(", narrowest point %1 mm (−%2 %)")
                                   .arg(ui::numberText(along.stenosis->diameterMm, 1),
                                        ui::numberText(along.stenosis->percent, 0))
                      : mean;
}

}   // namespace angiopose::app
