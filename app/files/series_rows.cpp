#include "app/files/series_rows.h"

#include "app/texts/number_text.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"

#include <QCoreApplication>

#include <algorithm>

namespace angiopose::app {
namespace {

struct SeriesWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::SeriesRows)
};

QString numberedName(int number)
{
    return SeriesWords::tr("Series %1").arg(number);
}

QString sizeText(const io::DicomSeries& series)
{
    const io::SliceRecord& first = series.slices.front();
    const bool isPlanned = !series.isAngiogram && !series.problem;
    const Eigen::Vector3i size =
        isPlanned ? series.stack.geometry.size : Eigen::Vector3i(first.size.x(), first.size.y(), 0);
    const QString plane = QStringLiteral("%1 × %2").arg(size.x()).arg(size.y());
    return isPlanned ? plane + QStringLiteral(" × %1").arg(size.z()) : plane;
}

QString spacingText(const io::DicomSeries& series)
{
    if (series.isAngiogram || series.problem) {
        return {};
    }
    QStringList parts;
    for (const double spacing : series.stack.geometry.spacingMm) {
        parts << ui::numberText(spacing, 2);
    }
    return parts.join(QStringLiteral(" × "));
}

ui::SeriesRow rowOf(const io::DicomSeries& series)
{
    ui::SeriesRow row;
    row.id = QString::fromStdString(series.id);
    row.description =
        QString::fromStdString(series.description.empty() ? series.identity.description : series.description);
    if (row.description.isEmpty()) {
        row.description = numberedName(series.number);
    }
    if (series.part) {
        row.description += QStringLiteral(" (%1)").arg(ui::messageText(series.part));
    }
    row.modality = QString::fromStdString(series.identity.modality);
    row.imageCount = static_cast<int>(series.slices.size());
    row.size = sizeText(series);
    row.spacingMm = spacingText(series);
    row.date = QString::fromStdString(series.identity.studyDate);
    row.isOpenable = !series.problem;
    if (!row.isOpenable) {
        row.notes << ui::messageText(series.problem);
    }
    for (const core::Message& warning : series.warnings) {
        row.notes << ui::messageText(warning);
    }
    return row;
}

}   // namespace

std::vector<ui::SeriesRow> seriesRows(const std::vector<io::DicomSeries>& series)
{
    std::vector<ui::SeriesRow> rows(series.size());
    std::ranges::transform(series, rows.begin(), rowOf);
    return rows;
}

}   // namespace angiopose::app
