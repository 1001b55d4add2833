#include "app/files/study_rows.h"

#include "ui/words/message_text.h"
#include "ui/words/number.h"

#include <QCoreApplication>

namespace angiopose::app {
namespace {

struct StudyWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::StudyRows)
};

QString joined(QStringList parts)
{
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" · "));
}

QString readable(const std::string& name)
{
    return QString::fromStdString(name).replace(u'^', u' ').simplified();
}

QString patientWords(const io::StudyPatient& patient, int place, IdentityShown shown)
{
    if (shown == IdentityShown::No) {
        return StudyWords::tr("Patient %1 (identity hidden)").arg(place);
    }
    const core::StudyIdentity& who = patient.identity;
    const QString name = readable(who.patientName);
    QStringList parts{name.isEmpty() ? StudyWords::tr("No name") : name};
    if (!who.patientId.empty()) {
        parts << StudyWords::tr("ID %1").arg(QString::fromStdString(who.patientId));
    }
    if (!who.birthDate.empty()) {
        parts << StudyWords::tr("born %1").arg(QString::fromStdString(who.birthDate));
    }
    return joined(parts);
}

QString studyWords(const io::Study& study, IdentityShown shown)
{
    QStringList parts{QString::fromStdString(study.identity.studyDate), QString::fromStdString(study.description)};
    if (shown == IdentityShown::Yes && !study.identity.accessionNumber.empty()) {
        parts << StudyWords::tr("accession %1").arg(QString::fromStdString(study.identity.accessionNumber));
    }
    const QString words = joined(parts);
    return words.isEmpty() ? StudyWords::tr("Study without date or description") : words;
}

QString descriptionOf(const io::DicomSeries& series)
{
    QString words =
        QString::fromStdString(series.description.empty() ? series.identity.description : series.description);
    if (words.isEmpty()) {
        words = StudyWords::tr("Series %1").arg(series.number);
    }
    return series.part ? QStringLiteral("%1 (%2)").arg(words, ui::messageText(series.part)) : words;
}

QString sizeOf(const io::DicomSeries& series)
{
    if (series.slices.empty() || series.slices.front().size.x() <= 0) {
        return {};
    }
    const Eigen::Vector2i& size = series.slices.front().size;
    return QStringLiteral("%1 × %2").arg(size.x()).arg(size.y());
}

/// Adds the slice spacing or, for a run, the frame rate.
void addPace(const io::StudySeries& studySeries, ui::StudySeriesRow& row)
{
    if (studySeries.use == io::SeriesUse::Vessels) {
        row.sortValue = studySeries.series.stack.geometry.spacingMm.z();
        row.frameRate = StudyWords::tr("%1 mm").arg(ui::numberText(row.sortValue, 2));
    } else if (studySeries.use == io::SeriesUse::View && studySeries.frameTimeMs > 0.0 && studySeries.imageCount > 1) {
        row.sortValue = 1000.0 / studySeries.frameTimeMs;
        row.frameRate = StudyWords::tr("%1 frames/s").arg(ui::numberText(row.sortValue, 1));
    }
}

QString passingWords()
{
    return StudyWords::tr("Not all files have been read yet, so it is not yet known which part of the series this is.");
}

QString missingWords(std::size_t files)
{
    return StudyWords::tr("Files listed in the DICOMDIR but missing: %1.").arg(files);
}

ui::StudySeriesRow::Use useOf(io::SeriesUse use)
{
    switch (use) {
        case io::SeriesUse::Vessels:
            return ui::StudySeriesRow::Use::Vessels;
        case io::SeriesUse::View:
            return ui::StudySeriesRow::Use::View;
        case io::SeriesUse::None:
            break;
    }
    return ui::StudySeriesRow::Use::None;
}

ui::StudySeriesRow rowOf(const io::StudySeries& studySeries, Numbering numbering)
{
    ui::StudySeriesRow row;
    row.key = keyOf(studySeries);
    row.use = useOf(studySeries.use);
    row.number = studySeries.series.number;
    row.modality = QString::fromStdString(studySeries.series.identity.modality);
    row.description = descriptionOf(studySeries.series);
    row.imageCount = studySeries.imageCount;
    row.size = sizeOf(studySeries.series);
    row.bodyPart = QString::fromStdString(studySeries.bodyPart);
    addPace(studySeries, row);
    if (studySeries.series.part && numbering == Numbering::Provisional) {
        row.use = ui::StudySeriesRow::Use::None;
        row.notes << passingWords();
    }
    if (studySeries.reason) {
        row.notes << ui::messageText(studySeries.reason);
    }
    if (studySeries.missingFiles > 0) {
        row.notes << missingWords(studySeries.missingFiles);
    }
    for (const core::Message& warning : studySeries.series.warnings) {
        row.notes << ui::messageText(warning);
    }
    return row;
}

}   // namespace

QString keyOf(const io::StudySeries& studySeries)
{
    // The number of a part may change during reading; by the slice count, a check mark stays with its part.
    const std::string size =
        studySeries.series.part ? "|" + std::to_string(studySeries.series.slices.size()) : std::string();
    return QString::fromStdString(studySeries.series.id + "|" + studySeries.series.identity.modality + "|" +
                                  studySeries.place + size);
}

std::vector<ui::PatientRow> studyRows(const io::StudyTree& tree, IdentityShown shown, Numbering numbering)
{
    std::vector<ui::PatientRow> rows;
    for (const io::StudyPatient& patient : tree.patients) {
        const core::StudyIdentity& who = patient.identity;
        ui::PatientRow& row = rows.emplace_back();
        row.key = QString::fromStdString("patient|" + who.patientName + "|" + who.patientId + "|" + who.birthDate);
        row.words = patientWords(patient, static_cast<int>(rows.size()), shown);
        for (const io::Study& study : patient.studies) {
            ui::StudyRow& added = row.studies.emplace_back();
            added.key = row.key + u'|' +
                        QString::fromStdString(study.identity.studyUid + study.identity.studyDate +
                                               study.identity.accessionNumber);
            added.words = studyWords(study, shown);
            for (const io::StudySeries& series : study.series) {
                added.series.push_back(rowOf(series, numbering));
            }
        }
    }
    return rows;
}

}   // namespace angiopose::app
