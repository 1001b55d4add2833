#include "app/report/report_captions.h"

#include "app/report/page_words.h"
#include "ui/theme/theme.h"
#include "ui/words/number.h"

#include <algorithm>

namespace angiopose::app {
namespace {

using report::PageWords;

/// Returns whether the vessels are colored by residuals rather than by another quantity or not at all.
bool showsResiduals(const ReportedView& view)
{
    return view.imageOptions.coloring == OverlayColoring::Residuals && view.target.pointCount() > 0 &&
           !view.imageOptions.drr && view.imageOptions.vessels != ui::OverlayMode::Hidden;
}

double scaleEndMm(const core::Case& session)
{
    const auto camera = core::cameraOf(session.shown());
    if (!camera) {
        return 0.0;
    }
    const double depthMm =
        std::max((session.shown().cameraFromPatient * core::centroidInPatient(*session.vessels.tree)).z(),
                 core::minProjectableDepthMm);
    return residualScaleMaximumPx(camera.value(), depthMm) * core::millimetersPerPixel(camera.value(), depthMm);
}

/// Returns a color sample followed by its meaning. The sample is a character, so that it is also printed.
QString sample(const ui::Color& color, const QString& meaning)
{
    return QStringLiteral("&nbsp;&nbsp;<span style=\"color:%1\">&#9632;</span>&nbsp;%2")
        .arg(QString::fromStdString(color.hex()), meaning.toHtmlEscaped());
}

}   // namespace

bool showsInitialPose(const ReportedView& view)
{
    const auto start = core::initialPoseOf(view.session);
    return start && start.value().matrix() != view.session.shown().cameraFromPatient.matrix();
}

QString pairCaptions(const ReportedView& view, int widthPx)
{
    if (!showsInitialPose(view)) {
        return {};
    }
    const QString after =
        view.session.shown().result ? PageWords::tr("After: registered") : PageWords::tr("After: pose set manually");
    return QStringLiteral(
               "<table width=\"%1\" style=\"margin-top:6px\" cellspacing=\"0\" cellpadding=\"0\"><tr>"
               "<td width=\"50%\"><b>%2</b></td><td width=\"50%\"><b>%3</b></td></tr></table>")
        .arg(QString::number(widthPx), PageWords::tr("Before: initial pose").toHtmlEscaped(), after.toHtmlEscaped());
}

QString colorLegend(const ReportedView& view)
{
    if (!showsResiduals(view)) {
        return {};
    }
    const double endMm = scaleEndMm(view.session);
    const auto at = [endMm](double fraction) {
        return sample(ui::residualColor(fraction), ui::numberText(fraction * endMm, 0) + QStringLiteral(" mm"));
    };
    return QStringLiteral("<p style=\"margin-top:2px; margin-bottom:6px; color:#555555\">%1%2</p>")
        .arg(PageWords::tr("Colors: distance to the vessels traced in the image").toHtmlEscaped(),
             at(0.0) + at(0.5) + at(1.0) + sample(ui::residualColorAboveScale(), PageWords::tr("farther")));
}

}   // namespace angiopose::app
