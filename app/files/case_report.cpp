#include "app/files/case_report.h"

#include "app/messages/says.h"
#include "app/words/geometry_state.h"
#include "core/case/case_patients.h"
#include "ui/panels/result_sentences.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"
#include "ui/words/terms.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QImage>
#include <QPageSize>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace angiopose::app {
namespace {

constexpr int pictureWidthPx = 900;   // of one of the two
constexpr int pageDpi = 96;   // as browsers count: one size for both kinds
constexpr int shownWidth = 670;   // of 680 between the margins
constexpr std::size_t branchesListed = 12;

/// The words of this file.
struct ReportWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::CaseReport)
};

using Rows = std::vector<std::pair<QString, QString>>;

QString heading(const QString& text)
{
    return QStringLiteral("<h3>%1</h3>").arg(text.toHtmlEscaped());
}

/// Two columns: what it is, what it is here.
QString table(const Rows& rows)
{
    QString text = QStringLiteral("<table cellspacing=\"0\" cellpadding=\"2\">");
    for (const auto& [name, value] : rows) {
        text += QStringLiteral("<tr><td style=\"color:#555555\">%1&nbsp;&nbsp;</td><td>%2</td></tr>")
                    .arg(name.toHtmlEscaped(), value.toHtmlEscaped());
    }
    return text + QStringLiteral("</table>");
}

QString list(const QStringList& sentences)
{
    QString text = QStringLiteral("<ul>");
    for (const QString& sentence : sentences) {
        text += QStringLiteral("<li>%1</li>").arg(sentence.toHtmlEscaped());
    }
    return text + QStringLiteral("</ul>");
}

QString fromCore(const std::string& text)
{
    return QString::fromStdString(text);
}

double mmPerPxOf(const core::Case& theCase)
{
    const auto camera = core::cameraOf(theCase.shown());
    const double depthMm = (theCase.shown().cameraFromPatient * core::centroidInPatient(*theCase.vessels.tree)).z();
    return camera ? core::millimetresPerPixel(camera.value(), std::max(depthMm, core::minProjectableDepthMm)) : 0.0;
}

/// That the images are not of one patient stands where nobody overlooks it.
QString mismatchLines(const core::Case& theCase)
{
    QString lines;
    for (const core::Message& mismatch : core::findMismatch(theCase)) {
        lines +=
            QStringLiteral("<p><b style=\"color:#b00020\">%1</b></p>").arg(ui::messageText(mismatch).toHtmlEscaped());
    }
    return lines;
}

QString titleLines(const CaseReport& report)
{
    const core::StudyIdentity& study = report.theCase.shown().angiogram->identity;
    QStringList patient;
    if (report.look.identity == Identity::Shown) {
        for (const std::string& part : {study.patientName, study.patientId, study.birthDate, study.institution}) {
            patient << (part.empty() ? QStringList()
                                     : QStringList(fromCore(part).replace(QLatin1Char('^'), QLatin1Char(' '))));
        }
    } else {
        patient << ui::messageText(says::identityHidden());
    }
    return QStringLiteral("<h2>%1</h2><p><b style=\"color:#9a5b00\">%2</b> · %3</p>")
               .arg(fromCore(report.theCase.title).toHtmlEscaped(),
                    ui::messageText(says::notForClinicalUse()).toHtmlEscaped(),
                    patient.join(QStringLiteral(" · ")).toHtmlEscaped()) +
           mismatchLines(report.theCase);
}

QString resultPart(const CaseReport& report)
{
    const core::RegistrationResult& judged = report.judgement;
    const core::DistanceMetrics& metrics = judged.metrics;
    Rows rows{
        {ReportWords::tr("Median distance"),
         ReportWords::tr("%1 mm (%2 px)")
             .arg(ui::numberText(metrics.medianMm, 2), ui::numberText(metrics.medianPx, 2))},
        {ReportWords::tr("95 % nearer than"),
         ReportWords::tr("%1 mm (%2 px)").arg(ui::numberText(metrics.p95Mm, 2), ui::numberText(metrics.p95Px, 2))},
        {ReportWords::tr("Traced vessels covered"),
         QStringLiteral("%1 %").arg(ui::numberText(100.0 * metrics.coverage, 0))}};
    if (report.theCase.shown().result) {
        rows.emplace_back(ReportWords::tr("Method"), fromCore(judged.method) + QStringLiteral(" · ") +
                                                         ui::termText(core::toText(judged.stopReason)));
        const core::Provenance& provenance = report.theCase.shown().result->provenance;
        const QDateTime found = QDateTime::fromString(fromCore(provenance.time), Qt::ISODate).toLocalTime();
        if (found.isValid()) {
            rows.emplace_back(
                ReportWords::tr("Found"),
                ui::languageLocale().toString(found, QLocale::ShortFormat) +
                    (provenance.author.empty() ? QString() : QStringLiteral(" · ") + fromCore(provenance.author)));
        }
    } else {
        rows.emplace_back(ReportWords::tr("Method"), ReportWords::tr("pose set by hand"));
    }
    const ui::ResultSentences sentences =
        ui::sentencesOf(judged, *report.theCase.vessels.tree, mmPerPxOf(report.theCase));
    return heading(ReportWords::tr("Result")) + table(rows) + list(sentences.certain + sentences.doubtful);
}

QString branchPart(const CaseReport& report)
{
    std::vector<core::BranchResidual> worstFirst = report.judgement.branches;
    std::ranges::stable_sort(worstFirst, std::greater{}, &core::BranchResidual::medianPx);
    const std::size_t count = std::min(worstFirst.size(), branchesListed);
    Rows rows;
    for (const core::BranchResidual& residual : std::span(worstFirst).first(count)) {
        if (const core::VesselBranch* branch = report.theCase.vessels.tree->find(residual.branchId)) {
            rows.emplace_back(ui::displayName(*branch),
                              ReportWords::tr("%1 mm median · %2 mm long")
                                  .arg(ui::numberText(residual.medianPx * mmPerPxOf(report.theCase), 2),
                                       ui::numberText(branch->lengthMm(), 0)));
        }
    }
    const QString name = worstFirst.size() > count
                             ? ReportWords::tr("The %1 worst of %2 branches").arg(count).arg(worstFirst.size())
                             : ReportWords::tr("Branches, the worst first");
    return heading(name) + table(rows);
}

QString geometryPart(const CaseReport& report)
{
    const ui::GeometryState state = geometryState(report.theCase);
    Rows rows;
    for (std::size_t i = 0; i < ui::geometryValueCount; ++i) {
        const auto value = static_cast<ui::GeometryValue>(i);
        const core::Sourced<double> shown = ui::shownValue(state, value);
        if (!shown.value || shown.origin == core::Origin::Missing) {
            continue;
        }
        const ui::GeometryValueKind& kind = ui::kindOf(value);
        const bool isAngle = kind.format.unit == QStringLiteral("°");   // written close to its number
        rows.emplace_back(QCoreApplication::translate("angiopose::ui::GeometryPanel", kind.label),
                          ui::numberText(*shown.value, kind.format.decimals) +
                              (isAngle ? QString() : QStringLiteral(" ")) + kind.format.unit +
                              QStringLiteral(" (%1)").arg(ui::messageText(originWord(shown.origin))));
    }
    return heading(ReportWords::tr("Geometry")) + table(rows);
}

QString posePart(const CaseReport& report)
{
    QString text =
        heading(ReportWords::tr("Pose: camera from patient, mm")) + QStringLiteral("<table cellpadding=\"3\">");
    for (int row = 0; row < 4; ++row) {
        text += QStringLiteral("<tr>");
        for (int column = 0; column < 4; ++column) {
            text +=
                QStringLiteral("<td align=\"right\">%1</td>")
                    .arg(report.theCase.shown().cameraFromPatient.matrix()(row, column), 0, 'f', 6);   // to be copied
        }
        text += QStringLiteral("</tr>");
    }
    return text + QStringLiteral("</table>");
}

QString inputPart(const CaseReport& report)
{
    Rows rows;
    const auto add = [&rows](const QString& name, const core::InputFile& file) {
        if (!file.path.empty()) {
            rows.emplace_back(name, QFileInfo(fromCore(file.path)).fileName() + QStringLiteral(" · SHA-256 ") +
                                        fromCore(file.sha256).left(16));
        }
    };
    add(ReportWords::tr("Vessels"), report.theCase.vessels.file);
    add(ReportWords::tr("Angiogram"), report.theCase.shown().imageFile);
    add(ReportWords::tr("Traced vessels"), report.theCase.shown().target.file);
    rows.emplace_back(ReportWords::tr("Program"), QStringLiteral("AngioPose ") + QStringLiteral(ANGIOPOSE_VERSION));
    rows.emplace_back(ReportWords::tr("Made"),
                      ui::languageLocale().toString(QDateTime::currentDateTime(), QLocale::ShortFormat) +
                          (report.author.isEmpty() ? QString() : QStringLiteral(" · ") + report.author));
    return heading(ReportWords::tr("Inputs")) + table(rows) +
           QStringLiteral("<p><br/>%1 ____________________________</p>")
               .arg(ReportWords::tr("Signature").toHtmlEscaped());
}

/// Two columns of parts.
QString beside(const QString& left, const QString& right)
{
    return QStringLiteral(
               "<table width=\"100%\"><tr><td width=\"50%\" valign=\"top\">%1</td>"
               "<td width=\"50%\" valign=\"top\">%2</td></tr></table>")
        .arg(left, right);
}

QString htmlOf(const CaseReport& report, const QString& pictureUrl, const QSize& pictureSize)
{
    const QSize shown = pictureSize.scaled(shownWidth, pictureSize.height(), Qt::KeepAspectRatio);
    const QString picture = QStringLiteral("<p><img src=\"%1\" width=\"%2\" height=\"%3\"/></p>")
                                .arg(pictureUrl)
                                .arg(shown.width())
                                .arg(shown.height());
    return QStringLiteral(
               "<html><head><meta charset=\"utf-8\"/><title>%1</title></head>"
               "<body style=\"font-family:sans-serif; font-size:8.5pt\">")
               .arg(fromCore(report.theCase.title).toHtmlEscaped()) +
           titleLines(report) + picture +
           beside(resultPart(report) + branchPart(report), geometryPart(report) + posePart(report)) +
           inputPart(report) + QStringLiteral("</body></html>");
}

/// The overlay, beside the start pose where there is one.
core::Result<QImage> pictureOf(const CaseReport& report)
{
    OverlayPictureOptions look = report.look;
    look.widthPx = pictureWidthPx;
    look.isStartBeside = static_cast<bool>(core::startPoseOf(report.theCase));
    const auto drawn = drawOverlay(report.theCase, report.target, look);
    if (!drawn) {
        return drawn.error();
    }
    const core::ColorImage& picture = drawn.value();
    return QImage(picture.rgb.data(), picture.width, picture.height, qsizetype{3} * picture.width,
                  QImage::Format_RGB888)
        .copy();
}

QByteArray pdfOf(const CaseReport& report, const QImage& picture)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(15.0, 15.0, 15.0, 15.0), QPageLayout::Millimeter);
    writer.setResolution(pageDpi);
    writer.setTitle(fromCore(report.theCase.title));
    writer.setCreator(QStringLiteral("AngioPose ") + QStringLiteral(ANGIOPOSE_VERSION));
    QTextDocument document;
    document.documentLayout()->setPaintDevice(&writer);
    document.setPageSize(QSizeF(writer.width(), writer.height()));
    document.setDocumentMargin(0.0);
    document.addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("overlay")), picture);
    document.setHtml(htmlOf(report, QStringLiteral("overlay"), picture.size()));
    document.print(&writer);
    return bytes;
}

QByteArray pngOf(const QImage& picture)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    picture.save(&buffer, "PNG");
    return bytes;
}

}   // namespace

core::Result<QByteArray> reportBytes(const CaseReport& report, ReportKind kind)
{
    const auto picture = pictureOf(report);
    if (!picture) {
        return picture.error();
    }
    if (kind == ReportKind::Pdf) {
        return pdfOf(report, picture.value());
    }
    const QString inside =
        QStringLiteral("data:image/png;base64,") + QString::fromLatin1(pngOf(picture.value()).toBase64());
    return htmlOf(report, inside, picture.value().size()).toUtf8();
}

}   // namespace angiopose::app