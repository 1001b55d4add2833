#pragma once

#include "app/texts/overlay_picture.h"
#include "core/case/case.h"

#include <QByteArray>
#include <QString>

namespace angiopose::app {

/// One case on one page or two: the overlay before and after, what it measures and how far it can be trusted, the
/// geometry with its origins, pose, inputs with hashes, who made it and when. In the language of the window.
struct CaseReport {
    core::Case theCase;
    core::RegistrationResult judgement;   ///< of the pose that is shown
    core::Centerline2d target;
    OverlayPictureOptions look;
    QString author;
};

enum class ReportKind { Pdf, Html };

/// A page for people, HTML with its pictures inside. Fails where no overlay can be drawn.
core::Result<QByteArray> reportBytes(const CaseReport& report, ReportKind kind);

}   // namespace angiopose::app