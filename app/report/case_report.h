#pragma once

#include "app/texts/overlay_picture.h"
#include "core/case/case.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace angiopose::app {

/// One view of the case as the report presents it.
struct ReportedView {
    core::Case session;   ///< with this view shown
    OverlayPictureOptions look;
    core::Centerline2d target;
    core::RegistrationResult judgement;   ///< of the view's current pose
    std::optional<core::Message>
        problem;   ///< reason why the view cannot be evaluated; the three members above are empty then
};

/// Report on one case, with a section for each view: overlay before and after, measurements, confidence, geometry with
/// the origin of its values, and pose; then inputs with hashes, author and time. In the language and typeface of the
/// window.
struct CaseReport {
    std::vector<ReportedView> views;   ///< the shown view first
    QString author;
    QStringList typeface;   ///< font families, the preferred one first
    QString templatePath;   ///< see readReportTemplate
};

/// Evaluates every view: by the registration that found its pose, else against its target (`shownTarget`, or the trace
/// of the other views). `look` applies to the shown view; the others have no DRR and choose their own window/level.
/// Fails if the shown view cannot be evaluated. Slow; call it on a worker thread.
core::Result<std::vector<ReportedView>> judgedViews(const core::Case& session, const core::Centerline2d& shownTarget,
                                                    const OverlayPictureOptions& look);

enum class ReportKind { Pdf, Html };

/// Report as PDF, or as HTML with embedded images. Fails if the template is invalid or the shown view cannot be
/// rendered.
core::Result<QByteArray> reportBytes(const CaseReport& report, ReportKind kind);

}   // namespace angiopose::app
