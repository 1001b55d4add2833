#pragma once

#include "app/texts/overlay_picture.h"
#include "core/case/case.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace angiopose::app {

/// One view of the case and what the report says of it.
struct ReportedView {
    core::Case session;   ///< with this view shown
    OverlayPictureOptions look;
    core::Centerline2d target;
    core::RegistrationResult judgement;   ///< of the view's pose
    std::optional<core::Message> problem;   ///< why the view cannot be judged; the three above are empty then
};

/// One case on a page or more, a part for every view: the overlay before and after, what it measures and how far it can
/// be trusted, the geometry with its origins, the pose; then inputs with hashes, who made it and when. In the language
/// and the typeface of the window.
struct CaseReport {
    std::vector<ReportedView> views;   ///< the shown one first
    QString author;
    QStringList typeface;   ///< families, the preferred one first
    QString templatePath;   ///< see readReportTemplate
};

/// Judges every view: by the run that found its pose, else by its target (`shownTarget`, or what is traced in the other
/// views). `look` is the shown view's; the others have no radiograph and find their own grey values. Fails where the
/// shown view cannot be judged. Takes its time: for a worker.
core::Result<std::vector<ReportedView>> judgedViews(const core::Case& session, const core::Centerline2d& shownTarget,
                                                    const OverlayPictureOptions& look);

enum class ReportKind { Pdf, Html };

/// A page for people, HTML with its pictures inside. Fails where the template is of no use and where
/// the shown view cannot be drawn.
core::Result<QByteArray> reportBytes(const CaseReport& report, ReportKind kind);

}   // namespace angiopose::app
