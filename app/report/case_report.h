#pragma once

#include "app/texts/overlay_image.h"
#include "core/case/case.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace angiopose::app {

/// One view of the case as it appears in the report.
struct ReportedView {
    core::Case session;   ///< case that displays this view
    OverlayImageOptions imageOptions;
    core::Centerline2d target;
    core::RegistrationResult evaluation;   ///< evaluation of the view's current pose
    std::optional<core::Message>
        problem;   ///< reason why the view cannot be evaluated; if set, the members above are empty
};

/// Content of a report on one case, in the UI language and font. A section for each view contains the overlay before
/// and after registration, measurements, confidence, geometry with the origin of its values, and the pose. Inputs with
/// hashes, author and time follow.
struct CaseReport {
    std::vector<ReportedView> views;   ///< views of the report, the shown view first
    QString author;
    QStringList typeface;   ///< font families in order of preference
    QString templatePath;   ///< see readReportTemplate
};

/// Evaluates every view: from the registration that found its pose, or else against its target (`shownTarget` for the
/// shown view, the trace for other views). `look` applies to the shown view; the other views have no DRR and use
/// automatic window/level. Fails if the shown view cannot be evaluated. Slow; call it on a worker thread.
core::Result<std::vector<ReportedView>> evaluateViews(const core::Case& session, const core::Centerline2d& shownTarget,
                                                      const OverlayImageOptions& imageOptions);

enum class ReportKind { Pdf, Html };

/// Returns the report as PDF, or as HTML with embedded images. Fails if the template is invalid or the shown view
/// cannot be rendered.
core::Result<QByteArray> reportBytes(const CaseReport& report, ReportKind kind);

}   // namespace angiopose::app
