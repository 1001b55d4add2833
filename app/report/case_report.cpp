#include "app/report/case_report.h"

#include "app/report/report_captions.h"
#include "app/report/report_page.h"
#include "app/texts/pose_origin.h"
#include "core/case/registration_input.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QImageReader>
#include <QPageSize>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>

#include <algorithm>
#include <utility>

namespace angiopose::app {
namespace {

constexpr int pictureWidthPx = 900;   // width of each of the two images
constexpr int pageDpi = 96;   // as in browsers, so that the PDF and HTML reports have the same layout
constexpr int markPx = 96;

core::Result<core::RegistrationResult> judgementOfView(const core::Case& session, const core::Centerline2d& target)
{
    const auto input = core::registrationInputOf(session, target);
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
                                      const OverlayImageOptions& look)
{
    if (!target) {
        return target.error();
    }
    const auto evaluation = judgementOfView(session, target.value());
    if (!evaluation) {
        return evaluation.error();
    }
    return ReportedView{session, look, target.value(), evaluation.value(), {}};
}

/// Draws the overlay image, side by side with the initial pose if that differs.
core::Result<QImage> pictureOf(const ReportedView& view)
{
    OverlayImageOptions look = view.look;
    look.widthPx = pictureWidthPx;
    look.isInitialPoseShown = showsInitialPose(view);
    const auto drawn = drawOverlay(view.session, view.target, look);
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
                                                      const OverlayImageOptions& look)
{
    auto shown = judgedView(session, shownTarget, look);
    if (!shown) {
        return shown.error();
    }
    OverlayImageOptions ofOthers = look;
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
