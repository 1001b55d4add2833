#pragma once

#include "core/support/result.h"

#include <QHash>
#include <QImage>
#include <QString>

#include <functional>
#include <vector>

namespace angiopose::app {

/// The page of a report as its user wants it: HTML with marks such as {{views}}, which are filled in.
struct ReportTemplate {
    QString html;   ///< without comments; its own pictures are marks, too
    std::vector<QImage> pictures;   ///< of its own
};

QByteArray builtInReportTemplate();   ///< the text that one's own begins as

/// A template and the pictures beside it; an empty path: the built-in one. Fails where it cannot be read, where it
/// lacks what every report must say, where a mark is unknown and where a picture is not beside it. Reads files: for a
/// worker.
core::Result<ReportTemplate> readReportTemplate(const QString& path);

/// The page. `parts` are HTML by the names of the marks; what they hold is not looked through for marks again. `urlOf`
/// names the template's own pictures.
QString filledPage(const ReportTemplate& page, const QHash<QString, QString>& parts,
                   const std::function<QString(std::size_t picture)>& urlOf);

}   // namespace angiopose::app
