#include "app/archive/archive_words.h"

#include "ui/words/language.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"

#include <QCoreApplication>
#include <QDate>
#include <QHash>

#include <array>

namespace angiopose::app {
namespace {

struct ArchiveWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::ArchiveWords)
};

/// Parses a date in ISO format or in the format of the UI language.
QDate dateOf(const QString& typed)
{
    const QDate international = QDate::fromString(typed, Qt::ISODate);
    return international.isValid() ? international : QDate::fromString(typed, QStringLiteral("d.M.yyyy"));
}

bool isRightDate(const QString& typed)
{
    return typed.isEmpty() || dateOf(typed).isValid();
}

QString dicomDate(const QString& typed)
{
    return typed.isEmpty() ? QString() : dateOf(typed).toString(QStringLiteral("yyyyMMdd"));
}

QString readableDate(const std::string& dicom)
{
    const QString text = QString::fromStdString(dicom);
    const QDate date = QDate::fromString(text, QStringLiteral("yyyyMMdd"));
    return date.isValid() ? date.toString(Qt::ISODate) : text;
}

QString readableName(const std::string& name)
{
    const QString words = QString::fromStdString(name).replace(u'^', u' ').simplified();
    return words.isEmpty() ? ArchiveWords::tr("No name") : words;
}

QString modalityWords(const std::string& modalities)
{
    return QString::fromStdString(modalities).replace(u'\\', QStringLiteral(", "));
}

}   // namespace

ui::ArchiveEntry toArchiveEntry(const io::ArchiveNode& node)
{
    ui::ArchiveEntry entry;
    entry.name = QString::fromStdString(node.name);
    entry.host = QString::fromStdString(node.host);
    entry.port = node.port;
    entry.title = QString::fromStdString(node.title);
    entry.ownAeTitle = QString::fromStdString(node.ownAeTitle);
    entry.receivePort = node.receivePort;
    entry.isTls = node.isTls;
    entry.caFile = QString::fromStdString(node.caFile);
    entry.certificateFile = QString::fromStdString(node.certificateFile);
    entry.keyFile = QString::fromStdString(node.keyFile);
    entry.verifiesHost = node.verifiesHost;
    entry.webUrl = QString::fromStdString(node.webUrl);
    entry.authorizationFile = QString::fromStdString(node.authorizationFile);
    entry.responseTimeoutSeconds = node.responseTimeoutSeconds;
    return entry;
}

io::ArchiveNode toArchiveNode(const ui::ArchiveEntry& entry)
{
    io::ArchiveNode node;
    node.name = entry.name.toStdString();
    node.host = entry.host.toStdString();
    node.port = entry.port;
    node.title = entry.title.toStdString();
    node.ownAeTitle = entry.ownAeTitle.toStdString();
    node.receivePort = entry.receivePort;
    node.isTls = entry.isTls;
    node.caFile = entry.caFile.toStdString();
    node.certificateFile = entry.certificateFile.toStdString();
    node.keyFile = entry.keyFile.toStdString();
    node.verifiesHost = entry.verifiesHost;
    node.webUrl = entry.webUrl.toStdString();
    node.authorizationFile = entry.authorizationFile.toStdString();
    node.responseTimeoutSeconds = entry.responseTimeoutSeconds;
    return node;
}

std::optional<QString> firstInvalidDate(const ui::ArchiveSearch& search)
{
    for (const QString& typed : {search.from, search.to}) {
        if (!isRightDate(typed)) {
            return typed;
        }
    }
    return {};
}

io::ArchiveQuery toArchiveQuery(const ui::ArchiveSearch& search)
{
    io::ArchiveQuery query;
    query.patientName = search.patientName.toStdString();
    query.patientId = search.patientId.toStdString();
    query.modality = search.modality.toStdString();
    const QString from = dicomDate(search.from), to = dicomDate(search.to);
    if (!from.isEmpty() || !to.isEmpty()) {
        query.dates = (from == to ? from : from + u'-' + to).toStdString();
    }
    return query;
}

std::vector<ui::MatchRow> studyMatchRows(const std::vector<io::ArchiveMatch>& studies, IdentityVisibility identity)
{
    std::vector<ui::MatchRow> rows;
    QHash<QString, int> numbers;   // consecutive number by patient ID, shown if the identity is hidden
    for (const io::ArchiveMatch& study : studies) {
        ui::MatchRow& row = rows.emplace_back();
        row.key = QString::fromStdString(study.studyUid);
        row.date = readableDate(study.studyDate);
        row.modality = modalityWords(study.modalities);
        row.description = QString::fromStdString(study.studyDescription);
        row.images = study.objects;
        if (identity == IdentityVisibility::Shown) {
            row.what = readableName(study.patientName);
            row.patientId = QString::fromStdString(study.patientId);
        } else {
            const QString who = QString::fromStdString(study.patientName + '|' + study.patientId);
            const auto next = static_cast<int>(numbers.size()) + 1;
            row.what = ArchiveWords::tr("Patient %1 (identity hidden)").arg(numbers.value(who, next));
            numbers.insert(who, numbers.value(who, next));
        }
    }
    return rows;
}

std::vector<ui::MatchRow> seriesMatchRows(const std::vector<io::ArchiveMatch>& series)
{
    std::vector<ui::MatchRow> rows;
    for (const io::ArchiveMatch& match : series) {
        ui::MatchRow& row = rows.emplace_back();
        row.key = QString::fromStdString(match.seriesUid);
        row.what = ArchiveWords::tr("Series %1").arg(match.seriesNumber);
        row.date = readableDate(match.studyDate);
        row.modality = modalityWords(match.modalities);
        row.description = QString::fromStdString(match.seriesDescription);
        row.images = match.objects;
    }
    return rows;
}

QString byteSizeText(std::uint64_t bytes)
{
    static constexpr std::array units{"kB", "MB", "GB", "TB"};
    auto value = static_cast<double>(bytes) / 1000.0;
    std::size_t unit = 0;
    while (value >= 1000.0 && unit + 1 < units.size()) {
        value /= 1000.0;
        ++unit;
    }
    return QStringLiteral("%1 %2").arg(ui::numberText(value, unit < 2 ? 0 : 1), QLatin1String(units.at(unit)));
}

QString problemSummary(const core::Messages& problems)
{
    if (problems.empty()) {
        return {};
    }
    const QString first = ui::messageText(problems.front());
    return problems.size() == 1
               ? first
               : ui::joinSentences({first, ArchiveWords::tr("Number of further errors: %1.").arg(problems.size() - 1)});
}

}   // namespace angiopose::app
