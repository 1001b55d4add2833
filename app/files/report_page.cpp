#include "app/files/report_page.h"

#include "app/files/report_captions.h"
#include "app/files/report_measures.h"
#include "app/messages/says.h"
#include "app/words/geometry_state.h"
#include "app/words/view_words.h"
#include "core/case/case_patients.h"
#include "io/edited_curves.h"
#include "ui/panels/result_sentences.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"
#include "ui/words/method_words.h"
#include "ui/words/number.h"
#include "ui/words/terms.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>

#include <algorithm>
#include <span>
#include <utility>

namespace angiopose::app {
namespace {

constexpr int shownWidth = 680;   // all that is between the margins
constexpr int shownWidthOfOne = 340;   // as one of two; the page holds the rest, too
constexpr int markWidth = 36;
constexpr std::size_t branchesListed = 12;

/// The words of this file.
struct ReportWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::CaseReport)
};

using Rows = ReportRows;

QString fromCore(const std::string& text)
{
    return QString::fromStdString(text);
}

QString heading(const QString& text, const char* moreStyle = "")
{
    return QStringLiteral("<p style=\"font-size:10pt; font-weight:600; margin-top:10px; margin-bottom:3px%1\">%2</p>")
        .arg(QLatin1String(moreStyle), text.toHtmlEscaped());
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

/// A ground of its own, as the window's card has it, and the ink that is read on it.
struct Ground {
    const char* color;
    const char* ink;
};
constexpr Ground certainGround{"#e3f2e6", "#14532d"};
constexpr Ground doubtfulGround{"#fbefd9", "#7a4a00"};

/// Sentences on a ground, after a word that is seen first; nothing where there are none.
QString card(const QStringList& sentences, const Ground& ground, const QString& verdict = {})
{
    const QString first = verdict.isEmpty() ? QString()
                                            : QStringLiteral(
                                                  "<span style=\"font-size:11pt; font-weight:600\">%1</span>"
                                                  "&nbsp;&nbsp;")
                                                  .arg(verdict.toHtmlEscaped());
    return sentences.isEmpty() ? QString()
                               : QStringLiteral(
                                     "<table width=\"100%\" cellspacing=\"0\" cellpadding=\"5\"><tr>"
                                     "<td style=\"background-color:%1; color:%2\">%3</td></tr></table>")
                                     .arg(QLatin1String(ground.color), QLatin1String(ground.ink),
                                          first + ui::joinedSentences(sentences).toHtmlEscaped());
}

/// Two columns of parts.
QString beside(const QString& left, const QString& right)
{
    return QStringLiteral(
               "<table width=\"100%\"><tr><td width=\"50%\" valign=\"top\">%1</td>"
               "<td width=\"50%\" valign=\"top\">%2</td></tr></table>")
        .arg(left, right);
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
    return hasStartBeside(view) ? shownWidth : shownWidthOfOne;
}

double mmPerPxOf(const core::Case& theCase)
{
    const auto camera = core::cameraOf(theCase.shown());
    const double depthMm = (theCase.shown().cameraFromPatient * core::centroidInPatient(*theCase.vessels.tree)).z();
    return camera ? core::millimetresPerPixel(camera.value(), std::max(depthMm, core::minProjectableDepthMm)) : 0.0;
}

QString programWords()
{
    return QStringLiteral("AngioPose ") + QStringLiteral(ANGIOPOSE_VERSION);
}

/// ISO 8601 with the time zone: read alike everywhere.
QString timeWords(const QDateTime& time)
{
    const int minutes = time.offsetFromUtc() / 60;
    const QString zone = minutes == 0 ? QString()
                                      : QStringLiteral("%1%2:%3")
                                            .arg(minutes < 0 ? QLatin1Char('-') : QLatin1Char('+'))
                                            .arg(std::abs(minutes) / 60, 2, 10, QLatin1Char('0'))
                                            .arg(std::abs(minutes) % 60, 2, 10, QLatin1Char('0'));
    return time.toString(QStringLiteral("yyyy-MM-dd HH:mm")) + QStringLiteral(" UTC") + zone;
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

QString patientWords(const ReportedView& view)
{
    if (view.look.identity == Identity::Hidden) {
        return ui::messageText(says::identityHidden());
    }
    const core::StudyIdentity& study = view.theCase.shown().angiogram->identity;
    QStringList patient;
    for (const std::string& part : {study.patientName, study.patientId, study.birthDate, study.institution}) {
        patient << fromCore(part).replace(QLatin1Char('^'), QLatin1Char(' ')).simplified();
    }
    patient.removeAll(QString());
    return patient.join(QStringLiteral(" · "));
}

QString methodWordsOf(const core::RegistrationResult& judged)
{
    return ui::methodWords(judged.method) + QStringLiteral(" · ") + ui::termText(core::toText(judged.stopReason));
}

/// How the pose came about.
Rows originRows(const ReportedView& view)
{
    const auto& result = view.theCase.shown().result;
    if (!result) {
        const auto start = core::startPoseOf(view.theCase);
        const bool isStart = start && start.value().matrix() == view.theCase.shown().cameraFromPatient.matrix();
        return {{ReportWords::tr("Method"),
                 isStart ? ReportWords::tr("none: this is the start pose") : ReportWords::tr("pose set by hand")}};
    }
    Rows rows{{ReportWords::tr("Method"), methodWordsOf(*result)}};
    const QDateTime found = QDateTime::fromString(fromCore(result->provenance.time), Qt::ISODate).toLocalTime();
    if (found.isValid()) {
        const QString& author = fromCore(result->provenance.author);
        rows.emplace_back(ReportWords::tr("Found"),
                          timeWords(found) + (author.isEmpty() ? QString() : QStringLiteral(" · ") + author));
    }
    if (!core::resultOfShownFrame(view.theCase.shown())) {
        rows.emplace_back(ReportWords::tr("Found in"), ReportWords::tr("frame %1; picture and figures are of frame %2")
                                                           .arg(result->provenance.frame.value_or(0))
                                                           .arg(view.theCase.shown().frame));
    }
    return rows;
}

QString resultPart(const ReportedView& view)
{
    const core::DistanceMetrics& metrics = view.judgement.metrics;
    Rows rows{
        {ReportWords::tr("Median distance"),
         ReportWords::tr("%1 mm (%2 px)")
             .arg(ui::numberText(metrics.medianMm, 2), ui::numberText(metrics.medianPx, 2))},
        {ReportWords::tr("95 % nearer than"),
         ReportWords::tr("%1 mm (%2 px)").arg(ui::numberText(metrics.p95Mm, 2), ui::numberText(metrics.p95Px, 2))},
        {ReportWords::tr("Traced vessels covered"),
         QStringLiteral("%1 %").arg(ui::numberText(100.0 * metrics.coverage, 0))}};
    const Rows origin = originRows(view);
    rows.insert(rows.end(), origin.begin(), origin.end());
    return heading(ReportWords::tr("Result")) + table(rows);
}

/// Whether the pose is to be trusted, what that means, and what the program says of it.
QString verdictPart(const ReportedView& view)
{
    const ui::ResultSentences said =
        ui::sentencesOf(view.judgement, *view.theCase.vessels.tree, mmPerPxOf(view.theCase));
    if (!view.judgement.trustworthy) {
        const QString meaning = ReportWords::tr("This pose may be wrong. Do not use it as it is.");
        return card(QStringList{meaning} + said.certain + said.doubtful, doubtfulGround,
                    ReportWords::tr("Not trustworthy"));
    }
    const QString meaning =
        ReportWords::tr("No check speaks against this pose. That is no proof: look at the picture.");
    return card(QStringList{meaning} + said.certain, certainGround, ReportWords::tr("Trustworthy")) +
           card(said.doubtful, doubtfulGround);
}

QString branchPart(const ReportedView& view)
{
    std::vector<core::BranchResidual> worstFirst = view.judgement.branches;
    std::ranges::stable_sort(worstFirst, std::greater{}, &core::BranchResidual::medianPx);
    const std::size_t count = std::min(worstFirst.size(), branchesListed);
    Rows rows;
    for (const core::BranchResidual& residual : std::span(worstFirst).first(count)) {
        if (const core::VesselBranch* branch = view.theCase.vessels.tree->find(residual.branchId)) {
            rows.emplace_back(ui::displayName(*branch),
                              ReportWords::tr("%1 mm median · %2 mm long")
                                      .arg(ui::numberText(residual.medianPx * mmPerPxOf(view.theCase), 2),
                                           ui::numberText(branch->lengthMm(), 0)) +
                                  widthWords(*branch));
        }
    }
    const QString name = worstFirst.size() > count
                             ? ReportWords::tr("The %1 worst of %2 branches").arg(count).arg(worstFirst.size())
                             : ReportWords::tr("Branches, the worst first");
    return heading(name) + table(rows);
}

QString measuredPart(const core::Case& theCase)
{
    const Rows rows = measuredRows(theCase);
    return rows.empty() ? QString() : heading(ReportWords::tr("Measured in the image")) + table(rows);
}

QString checkedPart(const core::Case& theCase)
{
    const Rows rows = checkedRows(theCase);
    return rows.empty() ? QString() : heading(ReportWords::tr("Check points and rings")) + table(rows);
}

QString geometryPart(const core::Case& theCase)
{
    const ui::GeometryState state = geometryState(theCase);
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

QString posePart(const core::Case& theCase)
{
    QString text =
        heading(ReportWords::tr("Pose: camera from patient, mm")) + QStringLiteral("<table cellpadding=\"3\">");
    for (int row = 0; row < 4; ++row) {
        text += QStringLiteral("<tr>");
        for (int column = 0; column < 4; ++column) {
            text += QStringLiteral("<td align=\"right\">%1</td>")
                        .arg(theCase.shown().cameraFromPatient.matrix()(row, column), 0, 'f', 6);   // to be copied
        }
        text += QStringLiteral("</tr>");
    }
    return text + QStringLiteral("</table>");
}

/// Which view among those of the case.
enum class ReportPlace { Alone, First, Further };

/// All that is about one view. A further one begins a page, lest its picture part from what stands above it.
QString viewPart(const ReportedView& view, const QString& picture, ReportPlace place)
{
    const core::Case& theCase = view.theCase;
    const QString title = numberedTitle(theCase.views, theCase.shownView);
    if (view.problem) {
        return heading(title) + card({ui::messageText(*view.problem)}, doubtfulGround);
    }
    const QString above = place == ReportPlace::Alone   ? QString()
                          : place == ReportPlace::First ? heading(title)
                                                        : heading(title, "; page-break-before:always");
    return above + captionsOf(view, widthOf(view)) + picture + colorLineOf(view) + verdictPart(view) +
           beside(resultPart(view) + branchPart(view), geometryPart(theCase) + posePart(theCase)) +
           measuredPart(theCase) + checkedPart(theCase);
}

QString inputPart(const CaseReport& report)
{
    Rows rows;
    const auto add = [&rows](const QString& name, const core::InputFile& file) {
        if (!file.path.empty() || !file.sha256.empty()) {
            const QString known =
                file.path.empty() ? ReportWords::tr("edited by hand") : QFileInfo(fromCore(file.path)).fileName();
            rows.emplace_back(name, known + QStringLiteral(" · SHA-256 ") + fromCore(file.sha256).left(16));
        }
    };
    const core::Case& theCase = report.views.front().theCase;
    if (theCase.vessels.isLumenEdited) {
        rows.emplace_back(ReportWords::tr("Vessels"), ReportWords::tr("traced from a lumen mask edited by hand"));
        add(ReportWords::tr("Lumen mask"), theCase.vessels.file);
        add(ReportWords::tr("Scan"), theCase.vessels.scanFile);
    } else {
        add(ReportWords::tr("Vessels"), theCase.vessels.file);
    }
    for (std::size_t place = 0; place < theCase.views.size(); ++place) {
        const core::View& view = theCase.views[place];
        const QString number = theCase.views.size() > 1 ? QStringLiteral(" %1").arg(place + 1) : QString();
        add(ReportWords::tr("Angiogram") + number, view.imageFile);
        add(ReportWords::tr("Traced vessels") + number, io::exportedFileOf(view.target));
    }
    rows.emplace_back(ReportWords::tr("Program"), programWords());
    rows.emplace_back(ReportWords::tr("Made"),
                      timeWords(QDateTime::currentDateTime()) +
                          (report.author.isEmpty() ? QString() : QStringLiteral(" · ") + report.author));
    return heading(ReportWords::tr("Inputs")) + table(rows);
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
        views += viewPart(report.views[i],
                          picture.isNull() ? QString() : imageTag(urlOf(i), picture.size(), widthOf(report.views[i])),
                          report.views.size() == 1 ? ReportPlace::Alone
                          : i == 0                 ? ReportPlace::First
                                                   : ReportPlace::Further);
    }
    const std::size_t mark = report.views.size();
    const QHash<QString, QString> parts{
        {QStringLiteral("title"), fromCore(shown.theCase.title).toHtmlEscaped()},
        {QStringLiteral("notice"), ui::messageText(says::notForClinicalUse()).toHtmlEscaped()},
        {QStringLiteral("patient"), patientWords(shown).toHtmlEscaped()},
        {QStringLiteral("warnings"), mismatchLines(shown.theCase)},
        {QStringLiteral("views"), views},
        {QStringLiteral("inputs"), inputPart(report)},
        {QStringLiteral("signature"), ReportWords::tr("Signature").toHtmlEscaped()},
        {QStringLiteral("date"), timeWords(QDateTime::currentDateTime())},
        {QStringLiteral("author"), report.author.toHtmlEscaped()},
        {QStringLiteral("program"), programWords()},
        {QStringLiteral("mark"), imageTag(urlOf(mark), pictures[mark].size(), markWidth)},
        {QStringLiteral("typeface"), typefaceOf(report).toHtmlEscaped()}};
    return filledPage(page, parts, [&](std::size_t own) { return urlOf(mark + 1 + own); });
}

}   // namespace angiopose::app
