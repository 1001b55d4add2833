#include "app/report/case_report.h"

#include "app/messages/messages.h"
#include "app/report/page_words.h"
#include "app/report/report_captions.h"
#include "app/report/report_html.h"
#include "app/report/report_measures.h"
#include "app/report/report_parts.h"
#include "app/report/report_template.h"
#include "app/texts/pose_origin.h"
#include "app/words/view_words.h"
#include "core/case/case_patients.h"
#include "core/case/registration_input.h"
#include "io/edited_curves.h"
#include "ui/words/message_text.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QDateTime>
#include <QFileInfo>
#include <QImage>
#include <QImageReader>
#include <QPageSize>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>

#include <functional>
#include <utility>
#include <vector>

namespace angiopose::app {
namespace {

using namespace report;

constexpr int pictureWidthPx = 900;   // width of each of the two images
constexpr int pageDpi = 96;   // as in browsers, so that the PDF and HTML reports have the same layout
constexpr int markPx = 96;
constexpr int shownWidth = 680;   // full width between the margins
constexpr int shownWidthOfOne =
    340;   // width of a single image, the same as in a pair, so that everything fits on one page
constexpr int markWidth = 36;

/// Returns the URL by which the page refers to an image.
using PictureUrl = std::function<QString(std::size_t picture)>;

/// Images of the report: the overlays of its views in order, then the program's logo, then the images of the template.
using ReportPictures = std::vector<QImage>;

QString fromCore(const std::string& text)
{
    return QString::fromStdString(text);
}

QString imageTag(const QString& url, const QSize& size, int width)
{
    return QStringLiteral("<img src=\"%1\" width=\"%2\" height=\"%3\"/>")
        .arg(url)
        .arg(width)
        .arg(size.scaled(width, size.height(), Qt::KeepAspectRatio).height());
}

int widthOf(const ReportedView& view)
{
    return showsInitialPose(view) ? shownWidth : shownWidthOfOne;
}

QString programWords()
{
    return QStringLiteral("AngioPose ") + QStringLiteral(ANGIOPOSE_VERSION);
}

/// Returns a prominent warning if the images belong to different patients.
QString mismatchLines(const core::Case& session)
{
    QString lines;
    for (const core::Message& mismatch : core::findMismatch(session)) {
        lines +=
            QStringLiteral("<p><b style=\"color:#b00020\">%1</b></p>").arg(ui::messageText(mismatch).toHtmlEscaped());
    }
    return lines;
}

QString patientWords(const ReportedView& view)
{
    if (view.imageOptions.identity == Identity::Hidden) {
        return ui::messageText(messages::identityHidden());
    }
    const core::StudyIdentity& study = view.session.shown().angiogram->identity;
    QStringList patient;
    for (const std::string& part : {study.patientName, study.patientId, study.birthDate, study.institution}) {
        patient << fromCore(part).replace(QLatin1Char('^'), QLatin1Char(' ')).simplified();
    }
    patient.removeAll(QString());
    return patient.join(QStringLiteral(" · "));
}

/// Position of a view among the views of the report.
enum class ReportPlace { Alone, First, Further };

/// Returns the section on one view. Each view after the first starts a new page that keeps image and heading together.
QString viewSection(const ReportedView& view, const QString& picture, ReportPlace place)
{
    const core::Case& session = view.session;
    const QString title = numberedTitle(session.views, session.shownView);
    if (view.problem) {
        return heading(title) + card({ui::messageText(*view.problem)}, unreliableColors);
    }
    const QString above = place == ReportPlace::Alone   ? QString()
                          : place == ReportPlace::First ? heading(title)
                                                        : heading(title, "; page-break-before:always");
    const QString seen = pairCaptions(view, widthOf(view)) + picture + colorLegend(view);
    const QString verdict = verdictSection(view);   // placed first if the verdict is negative
    return above + (view.evaluation.trustworthy ? seen + verdict : verdict + seen) +
           sideBySideTable(resultSection(view) + branchSection(view), geometrySection(session) + poseSection(session)) +
           measurementSection(session) + targetPointSection(session);
}

QString inputPart(const CaseReport& report)
{
    ReportRows rows;
    const auto add = [&rows](const QString& name, const core::InputFile& file) {
        if (!file.path.empty() || !file.sha256.empty()) {
            const QString known =
                file.path.empty() ? PageWords::tr("edited manually") : QFileInfo(fromCore(file.path)).fileName();
            rows.emplace_back(name, known + QStringLiteral(" · SHA-256 ") + fromCore(file.sha256).left(16));
        }
    };
    const core::Case& session = report.views.front().session;
    if (session.vessels.isLumenEdited) {
        rows.emplace_back(PageWords::tr("Vessels"), PageWords::tr("traced from a manually edited lumen mask"));
        add(PageWords::tr("Lumen mask"), session.vessels.file);
        add(PageWords::tr("Scan"), session.vessels.scanFile);
    } else {
        add(PageWords::tr("Vessels"), session.vessels.file);
    }
    for (std::size_t place = 0; place < session.views.size(); ++place) {
        const core::View& view = session.views[place];
        const QString number = session.views.size() > 1 ? QStringLiteral(" %1").arg(place + 1) : QString();
        add(PageWords::tr("Angiogram") + number, view.imageFile);
        add(PageWords::tr("Traced vessels") + number, io::exportedFile(view.target));
    }
    rows.emplace_back(PageWords::tr("Program"), programWords());
    rows.emplace_back(PageWords::tr("Created"),
                      timestampText(QDateTime::currentDateTime()) +
                          (report.author.isEmpty() ? QString() : QStringLiteral(" · ") + report.author));
    return heading(PageWords::tr("Inputs")) + table(rows);
}

QString typefaceOf(const CaseReport& report)
{
    QStringList families;
    for (const QString& family : report.typeface) {
        families << QStringLiteral("'%1'").arg(family);
    }
    return (families << QStringLiteral("sans-serif")).join(QStringLiteral(", "));
}

/// Returns the report page as HTML, filled from its template; `urlOf` returns the URL of each image.
QString reportPage(const CaseReport& report, const ReportTemplate& page, const ReportPictures& pictures,
                   const PictureUrl& urlOf)
{
    const ReportedView& shown = report.views.front();
    QString views;
    for (std::size_t i = 0; i < report.views.size(); ++i) {
        const QImage& picture = pictures[i];
        views +=
            viewSection(report.views[i],
                        picture.isNull() ? QString() : imageTag(urlOf(i), picture.size(), widthOf(report.views[i])),
                        report.views.size() == 1 ? ReportPlace::Alone
                        : i == 0                 ? ReportPlace::First
                                                 : ReportPlace::Further);
    }
    const std::size_t mark = report.views.size();
    const QHash<QString, QString> parts{
        {QStringLiteral("title"), fromCore(shown.session.title).toHtmlEscaped()},
        {QStringLiteral("notice"), ui::messageText(messages::notForClinicalUse()).toHtmlEscaped()},
        {QStringLiteral("patient"), patientWords(shown).toHtmlEscaped()},
        {QStringLiteral("warnings"), mismatchLines(shown.session)},
        {QStringLiteral("views"), views},
        {QStringLiteral("inputs"), inputPart(report)},
        {QStringLiteral("signature"), PageWords::tr("Signature").toHtmlEscaped()},
        {QStringLiteral("date"), timestampText(QDateTime::currentDateTime())},
        {QStringLiteral("author"), report.author.toHtmlEscaped()},
        {QStringLiteral("program"), programWords()},
        {QStringLiteral("mark"), imageTag(urlOf(mark), pictures[mark].size(), markWidth)},
        {QStringLiteral("typeface"), typefaceOf(report).toHtmlEscaped()}};
    return fillTemplate(page, parts, [&](std::size_t own) { return urlOf(mark + 1 + own); });
}

core::Result<core::RegistrationResult> judgementOfView(const core::Case& session, const core::Centerline2d& target)
{
    const auto input = core::makeRegistrationInput(session, target);
    if (!input) {
        return input.error();
    }
    auto evaluated = core::evaluatePose(input.value(), session.shown().cameraFromPatient);
    if (!evaluated) {
        return evaluated.error();
    }
    core::RegistrationResult result = std::move(evaluated).value();
    addRegistrationResult(result, session.shown());
    return result;
}

core::Result<ReportedView> judgedView(const core::Case& session, const core::Result<core::Centerline2d>& target,
                                      const OverlayImageOptions& imageOptions)
{
    if (!target) {
        return target.error();
    }
    const auto evaluation = judgementOfView(session, target.value());
    if (!evaluation) {
        return evaluation.error();
    }
    return ReportedView{session, imageOptions, target.value(), evaluation.value(), {}};
}

/// Draws the overlay image, side by side with that of the initial pose if the poses differ.
core::Result<QImage> pictureOf(const ReportedView& view)
{
    OverlayImageOptions imageOptions = view.imageOptions;
    imageOptions.widthPx = pictureWidthPx;
    imageOptions.isInitialPoseShown = showsInitialPose(view);
    const auto drawn = drawOverlay(view.session, view.target, imageOptions);
    if (!drawn) {
        return drawn.error();
    }
    const core::ColorImage& picture = drawn.value();
    return QImage(picture.rgb.data(), picture.width, picture.height, qsizetype{3} * picture.width,
                  QImage::Format_RGB888)
        .copy();
}

/// Returns the logo of the program, large enough for print.
QImage programLogo()
{
    QImageReader reader(QStringLiteral(":/icons/angiopose.svg"));
    reader.setScaledSize({markPx, markPx});
    return reader.read();
}

QString nameInDocument(std::size_t picture)
{
    return QStringLiteral("picture%1").arg(picture);
}

QByteArray toPdf(const CaseReport& report, const ReportTemplate& page, const ReportPictures& pictures)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(15.0, 15.0, 15.0, 15.0), QPageLayout::Millimeter);
    writer.setResolution(pageDpi);
    writer.setTitle(QString::fromStdString(report.views.front().session.title));
    writer.setCreator(QStringLiteral("AngioPose ") + QStringLiteral(ANGIOPOSE_VERSION));
    QTextDocument document;
    document.documentLayout()->setPaintDevice(&writer);
    document.setPageSize(QSizeF(writer.width(), writer.height()));
    document.setDocumentMargin(0.0);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        document.addResource(QTextDocument::ImageResource, QUrl(nameInDocument(i)), pictures[i]);
    }
    document.setHtml(reportPage(report, page, pictures, nameInDocument));
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

QByteArray htmlOf(const CaseReport& report, const ReportTemplate& page, const ReportPictures& pictures)
{
    const auto inside = [&](std::size_t picture) {
        return QStringLiteral("data:image/png;base64,") + QString::fromLatin1(pngOf(pictures[picture]).toBase64());
    };
    return reportPage(report, page, pictures, inside).toUtf8();
}

}   // namespace

core::Result<std::vector<ReportedView>> evaluateViews(const core::Case& session, const core::Centerline2d& shownTarget,
                                                      const OverlayImageOptions& imageOptions)
{
    auto shown = judgedView(session, shownTarget, imageOptions);
    if (!shown) {
        return shown.error();
    }
    OverlayImageOptions ofOthers = imageOptions;
    ofOthers.range.reset();
    ofOthers.drr = nullptr;
    ofOthers.cutout = {};
    std::vector<ReportedView> views{std::move(shown).value()};
    for (std::size_t place = 0; place < session.views.size(); ++place) {
        if (place == session.shownView || !session.views[place].angiogram) {
            continue;
        }
        core::Case other = session;
        other.shownView = place;
        auto view = judgedView(other, core::targetOf(other.shown()), ofOthers);
        views.push_back(view ? std::move(view).value()
                             : ReportedView{std::move(other), ofOthers, {}, {}, view.error().message});
    }
    return views;
}

core::Result<QByteArray> reportBytes(const CaseReport& report, ReportKind kind)
{
    const auto page = readReportTemplate(report.templatePath);
    if (!page) {
        return page.error();
    }
    ReportPictures pictures;
    for (const ReportedView& view : report.views) {
        const auto picture = pictureOf(view);
        if (!picture && pictures.empty()) {
            return picture.error();
        }
        pictures.push_back(picture ? picture.value() : QImage());
    }
    pictures.push_back(programLogo());
    pictures.insert(pictures.end(), page.value().pictures.begin(), page.value().pictures.end());
    return kind == ReportKind::Pdf ? toPdf(report, page.value(), pictures) : htmlOf(report, page.value(), pictures);
}

}   // namespace angiopose::app
