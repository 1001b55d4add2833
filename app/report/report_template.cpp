#include "app/report/report_template.h"

#include "app/messages/messages.h"

#include <QBuffer>
#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <QRegularExpression>
#include <QStringDecoder>
#include <QStringList>

#include <optional>
#include <utility>

namespace angiopose::app {
namespace {

constexpr qint64 maxTextBytes = qint64{1} << 20;
constexpr qint64 maxPictureFileBytes = qint64{16} << 20;
constexpr int maxPictureSide = 8192;   // longer side, px

const QStringList& neededMarks()
{
    static const QStringList marks{QStringLiteral("notice"), QStringLiteral("warnings"), QStringLiteral("views")};
    return marks;
}

const QStringList& knownMarks()
{
    static const QStringList marks =
        neededMarks() + QStringList{QStringLiteral("title"),     QStringLiteral("patient"), QStringLiteral("inputs"),
                                    QStringLiteral("signature"), QStringLiteral("date"),    QStringLiteral("author"),
                                    QStringLiteral("program"),   QStringLiteral("mark"),    QStringLiteral("typeface")};
    return marks;
}

const QString pictureMark =
    QStringLiteral("picture ");   // followed by a number; the blank keeps it distinct from the user's placeholders

QString written(const QString& mark)
{
    return QStringLiteral("{{%1}}").arg(mark);
}

std::optional<QString> textOf(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly) || file.size() > maxTextBytes) {
        return {};
    }
    QStringDecoder utf8(QStringDecoder::Utf8);
    QString text = utf8(file.read(maxTextBytes));
    return utf8.hasError() || text.contains(QChar::Null) ? std::nullopt : std::optional(std::move(text));
}

bool isTaken(QImageReader& reader)
{
    const QByteArray format = reader.format();
    const QSize size = reader.size();
    return (format == "png" || format == "jpeg") && size.width() <= maxPictureSide && size.height() <= maxPictureSide;
}

/// Decodes an image embedded in the template.
QImage decodeEmbeddedPicture(const QString& url)
{
    QByteArray bytes = QByteArray::fromBase64(url.mid(url.indexOf(QLatin1Char(',')) + 1).toLatin1());
    QBuffer buffer(&bytes);
    QImageReader reader(&buffer);
    return isTaken(reader) ? reader.read() : QImage();
}

/// Loads an image from the folder of the template or a folder below it; refuses all other locations and the network.
QImage loadTemplatePicture(const QFileInfo& page, const QString& name)
{
    const QFileInfo file(page.dir(), name);
    const QString folder = page.dir().canonicalPath() + QLatin1Char('/');
    if (!file.canonicalFilePath().startsWith(folder) || file.size() > maxPictureFileBytes) {
        return {};
    }
    QImageReader reader(file.filePath());
    return isTaken(reader) ? reader.read() : QImage();
}

/// Loads the template's images and replaces references to them by placeholders.
core::Status loadPictures(ReportTemplate& page, const QString& path)
{
    static const QRegularExpression source(QStringLiteral("\\bsrc\\s*=\\s*(?:\"([^\"]*)\"|'([^']*)'|([^\\s\"'>]+))"),
                                           QRegularExpression::CaseInsensitiveOption);
    QString html;
    qsizetype done = 0;
    for (auto found = source.globalMatch(page.html); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const QString name = match.captured(1) + match.captured(2) + match.captured(3);
        QImage picture = name.startsWith(QLatin1String("data:image/")) ? decodeEmbeddedPicture(name)
                                                                       : loadTemplatePicture(QFileInfo(path), name);
        if (picture.isNull()) {
            return core::Error(messages::reportTemplatePicture(name.left(80).toStdString()));
        }
        html += page.html.mid(done, match.capturedStart() - done) +
                QStringLiteral("src=\"%1\"").arg(written(pictureMark + QString::number(page.pictures.size())));
        done = match.capturedEnd();
        page.pictures.push_back(std::move(picture));
    }
    page.html = html + page.html.mid(done);
    return core::Done{};
}

const QRegularExpression& markPattern()
{
    static const QRegularExpression pattern(QStringLiteral("\\{\\{\\s*([^{}]*?)\\s*\\}\\}"));
    return pattern;
}

/// Checks that the template contains all required placeholders and none that are unknown and would stay unfilled.
core::Status checkPlaceholders(const QString& html)
{
    QStringList found;
    for (auto marks = markPattern().globalMatch(html); marks.hasNext();) {
        found << marks.next().captured(1);
    }
    for (const QString& mark : neededMarks()) {
        if (!found.contains(mark)) {
            return core::Error(messages::reportTemplateLacks(written(mark).toStdString()));
        }
    }
    for (const QString& mark : std::as_const(found)) {
        if (!knownMarks().contains(mark)) {
            return core::Error(messages::reportTemplateUnknown(written(mark).toStdString(),
                                                               knownMarks().join(QStringLiteral(", ")).toStdString()));
        }
    }
    return core::Done{};
}

}   // namespace

QByteArray builtInReportTemplate()
{
    QFile file(QStringLiteral(":/report/template.html"));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

core::Result<ReportTemplate> readReportTemplate(const QString& path)
{
    const auto text = path.isEmpty() ? std::optional(QString::fromUtf8(builtInReportTemplate())) : textOf(path);
    if (!text) {
        return core::Error(messages::reportTemplateUnreadable(path.toStdString()));
    }
    static const QRegularExpression comment(QStringLiteral("<!--.*?(?:-->|\\z)"),
                                            QRegularExpression::DotMatchesEverythingOption);
    ReportTemplate page{QString(*text).remove(comment), {}};
    static const QRegularExpression fetching(
        QStringLiteral("<\\s*(script|link|iframe|object|embed|base)\\b|\\bsrcset\\s*=|\\burl\\s*\\(|@import"),
        QRegularExpression::CaseInsensitiveOption);
    if (const auto found = fetching.match(page.html); found.hasMatch()) {
        return core::Error(messages::reportTemplateFetches(found.captured().trimmed().toStdString()));
    }
    if (const auto checked = checkPlaceholders(page.html); !checked) {
        return checked.error();
    }
    if (const auto loaded = loadPictures(page, path); !loaded) {
        return loaded.error();
    }
    return page;
}

QString fillTemplate(const ReportTemplate& page, const QHash<QString, QString>& parts,
                     const std::function<QString(std::size_t picture)>& urlOf)
{
    QString html;
    qsizetype done = 0;
    for (auto marks = markPattern().globalMatch(page.html); marks.hasNext();) {
        const QRegularExpressionMatch match = marks.next();
        const QString mark = match.captured(1);
        html += page.html.mid(done, match.capturedStart() - done);
        html += mark.startsWith(pictureMark) ? urlOf(mark.mid(pictureMark.size()).toULongLong()) : parts.value(mark);
        done = match.capturedEnd();
    }
    return html + page.html.mid(done);
}

}   // namespace angiopose::app
