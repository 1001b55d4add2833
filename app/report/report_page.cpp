#include "app/report/report_page.h"

#include "app/messages/messages.h"
#include "app/report/page_words.h"
#include "app/report/report_captions.h"
#include "app/report/report_html.h"
#include "app/report/report_measures.h"
#include "app/report/report_parts.h"
#include "app/words/view_words.h"
#include "core/case/case_patients.h"
#include "io/edited_curves.h"
#include "ui/words/message_text.h"

#include <QDateTime>
#include <QFileInfo>

#include <algorithm>
#include <span>
#include <utility>

namespace angiopose::app {
namespace {

constexpr int shownWidth = 680;   // full width between the margins
constexpr int shownWidthOfOne =
    340;   // width of a single image: the same as in a pair, so that everything fits on one page
constexpr int markWidth = 36;

using namespace report;
using Rows = ReportRows;

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
    if (view.look.identity == Identity::Hidden) {
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

/// Section on one view. Every view after the first starts a new page, which keeps its image and heading together.
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
    const QString verdict = verdictSection(view);   // placed first if it is negative
    return above + (view.evaluation.trustworthy ? seen + verdict : verdict + seen) +
           sideBySideTable(resultSection(view) + branchSection(view), geometrySection(session) + poseSection(session)) +
           measurementSection(session) + targetPointSection(session);
}

QString inputPart(const CaseReport& report)
{
    Rows rows;
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

}   // namespace

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

}   // namespace angiopose::app
