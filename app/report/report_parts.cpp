#include "app/report/report_parts.h"

#include "app/messages/messages.h"
#include "app/report/page_words.h"
#include "app/report/report_html.h"
#include "app/report/report_measures.h"
#include "app/texts/fit_basis_lines.h"
#include "app/words/geometry_state.h"
#include "app/words/view_words.h"
#include "ui/panels/result_sentences.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"
#include "ui/words/terms.h"

#include <QCoreApplication>

#include <algorithm>
#include <span>

namespace angiopose::app::report {
namespace {

using Rows = ReportRows;

constexpr std::size_t branchesListed = 12;
constexpr const char* unreliableStyle = "; color:#9a5b00";   // amber that is dark enough for print

double mmPerPxOf(const core::Case& session)
{
    const auto camera = core::cameraOf(session.shown());
    const double depthMm = (session.shown().cameraFromPatient * core::centroidInPatient(*session.vessels.tree)).z();
    return camera ? core::millimetersPerPixel(camera.value(), std::max(depthMm, core::minProjectableDepthMm)) : 0.0;
}

QString methodWordsOf(const core::RegistrationResult& evaluated)
{
    return ui::methodName(evaluated.method) + QStringLiteral(" · ") + ui::termText(core::toText(evaluated.stopReason));
}

/// Returns the rows that describe the origin of the pose.
Rows originRows(const ReportedView& view)
{
    const auto& result = view.session.shown().result;
    if (!result) {
        const auto start = core::initialPoseOf(view.session);
        const bool isStart = start && start.value().matrix() == view.session.shown().cameraFromPatient.matrix();
        return {{PageWords::tr("Method"),
                 isStart ? PageWords::tr("none: this is the initial pose") : PageWords::tr("pose set manually")}};
    }
    Rows rows{{PageWords::tr("Method"), methodWordsOf(*result)}};
    const QDateTime found =
        QDateTime::fromString(QString::fromStdString(result->provenance.time), Qt::ISODate).toLocalTime();
    if (found.isValid()) {
        const QString& author = QString::fromStdString(result->provenance.author);
        rows.emplace_back(PageWords::tr("Registered"),
                          timestampText(found) + (author.isEmpty() ? QString() : QStringLiteral(" · ") + author));
    }
    if (!core::resultOfShownFrame(view.session.shown())) {
        rows.emplace_back(PageWords::tr("Registered in"), PageWords::tr("frame %1; image and values from frame %2")
                                                              .arg(result->provenance.frame.value_or(0) + 1)
                                                              .arg(view.session.shown().frame + 1));
    }
    return rows;
}

}   // namespace

QString timestampText(const QDateTime& time)
{
    const int minutes = time.offsetFromUtc() / 60;
    const QString zone = minutes == 0 ? QString()
                                      : QStringLiteral("%1%2:%3")
                                            .arg(minutes < 0 ? QLatin1Char('-') : QLatin1Char('+'))
                                            .arg(std::abs(minutes) / 60, 2, 10, QLatin1Char('0'))
                                            .arg(std::abs(minutes) % 60, 2, 10, QLatin1Char('0'));
    return time.toString(QStringLiteral("yyyy-MM-dd HH:mm")) + QStringLiteral(" UTC") + zone;
}

QString resultSection(const ReportedView& view)
{
    const core::DistanceMetrics& metrics = view.evaluation.metrics;
    Rows rows{
        {PageWords::tr("Median distance"),
         PageWords::tr("%1 mm (%2 px)").arg(ui::numberText(metrics.medianMm, 2), ui::numberText(metrics.medianPx, 2))},
        {PageWords::tr("95th percentile"),
         PageWords::tr("%1 mm (%2 px)").arg(ui::numberText(metrics.p95Mm, 2), ui::numberText(metrics.p95Px, 2))},
        {PageWords::tr("Coverage of traced vessels"),
         QStringLiteral("%1 %").arg(ui::numberText(100.0 * metrics.coverage, 0))}};
    const Rows origin = originRows(view);
    rows.insert(rows.end(), origin.begin(), origin.end());
    QStringList basis;
    if (const auto known = core::fitBasis(view.session, view.evaluation, view.target)) {
        for (const core::Message& words : fitBasisLines(*known, view.session.vessels)) {
            basis << ui::messageText(words);
        }
    }
    const char* const tone = view.evaluation.trustworthy ? "" : unreliableStyle;
    return heading(PageWords::tr("Result"), tone) + table(rows, tone) + card(basis, unreliableColors);
}

QString verdictSection(const ReportedView& view)
{
    const ui::ResultSentences sentences =
        ui::sentencesOf(view.evaluation, *view.session.vessels.tree, mmPerPxOf(view.session));
    if (!view.evaluation.trustworthy) {
        const QString meaning = PageWords::tr("This pose may be wrong. Do not use it without verification.");
        return heading(ui::messageText(messages::notReliable()), unreliableStyle) +
               card(QStringList{meaning} + sentences.certain + sentences.doubtful, unreliableColors,
                    PageWords::tr("Not reliable"));
    }
    const QString meaning = PageWords::tr("All checks passed. This is not proof: inspect the overlay.");
    return card(QStringList{meaning} + sentences.certain, reliableColors, PageWords::tr("Reliable")) +
           card(sentences.doubtful, unreliableColors);
}

QString branchSection(const ReportedView& view)
{
    std::vector<core::BranchResidual> worstFirst = view.evaluation.branches;
    std::ranges::stable_sort(worstFirst, std::greater{}, &core::BranchResidual::medianPx);
    const std::size_t count = std::min(worstFirst.size(), branchesListed);
    Rows rows;
    for (const core::BranchResidual& residual : std::span(worstFirst).first(count)) {
        if (const core::VesselBranch* branch = view.session.vessels.tree->find(residual.branchId)) {
            rows.emplace_back(ui::displayName(*branch),
                              PageWords::tr("%1 mm median · %2 mm long")
                                      .arg(ui::numberText(residual.medianPx * mmPerPxOf(view.session), 2),
                                           ui::numberText(branch->lengthMm(), 0)) +
                                  diameterText(*branch));
        }
    }
    const QString name = worstFirst.size() > count
                             ? PageWords::tr("Worst %1 of %2 branches").arg(count).arg(worstFirst.size())
                             : PageWords::tr("Branches, worst first");
    return heading(name) + table(rows);
}

QString measurementSection(const core::Case& session)
{
    const Rows rows = measurementRows(session);
    return rows.empty() ? QString() : heading(PageWords::tr("Measured in the image")) + table(rows);
}

QString targetPointSection(const core::Case& session)
{
    const Rows rows = targetPointRows(session);
    return rows.empty() ? QString() : heading(PageWords::tr("Target points and rings")) + table(rows);
}

QString geometrySection(const core::Case& session)
{
    const ui::GeometryState state = geometryState(session);
    Rows rows;
    for (std::size_t i = 0; i < ui::geometryValueCount; ++i) {
        const auto value = static_cast<ui::GeometryValue>(i);
        const core::SourcedValue<double> shown = ui::shownValue(state, value);
        if (!shown.value || shown.origin == core::Origin::Missing) {
            continue;
        }
        const ui::GeometryValueInfo& kind = ui::infoOf(value);
        const bool isAngle = kind.format.unit == QStringLiteral("°");   // no space before the unit
        rows.emplace_back(QCoreApplication::translate("angiopose::ui::GeometryPanel", kind.label),
                          ui::numberText(*shown.value, kind.format.decimals) +
                              (isAngle ? QString() : QStringLiteral(" ")) + kind.format.unit +
                              QStringLiteral(" (%1)").arg(ui::messageText(originMessage(shown.origin))));
    }
    return heading(PageWords::tr("Geometry")) + table(rows);
}

QString poseSection(const core::Case& session)
{
    QString text = heading(PageWords::tr("Pose (patient to camera), mm")) + QStringLiteral("<table cellpadding=\"3\">");
    for (int row = 0; row < 4; ++row) {
        text += QStringLiteral("<tr>");
        for (int column = 0; column < 4; ++column) {
            text += QStringLiteral("<td align=\"right\">%1</td>")
                        .arg(session.shown().cameraFromPatient.matrix()(row, column), 0, 'f',
                             6);   // full precision, since readers may copy the values
        }
        text += QStringLiteral("</tr>");
    }
    return text + QStringLiteral("</table>");
}

}   // namespace angiopose::app::report
