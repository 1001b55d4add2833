#pragma once

#include "core/support/result.h"

#include <QHash>
#include <QImage>
#include <QString>

#include <functional>
#include <vector>

namespace angiopose::app {

/// Report page as customized by the user: HTML with placeholders such as {{views}}.
struct ReportTemplate {
    QString html;   ///< without comments; its own images are placeholders, too
    std::vector<QImage> pictures;   ///< images of the template
};

QByteArray builtInReportTemplate();   ///< starting point for custom templates

/// Reads a template and the images next to it; an empty path selects the built-in one. Fails if it cannot be read,
/// lacks a required placeholder, contains an unknown one, or names an image that is not next to it. Reads files; call
/// it on a worker thread.
core::Result<ReportTemplate> readReportTemplate(const QString& path);

/// Fills in the template. `parts` maps placeholder names to HTML; placeholders inside the parts are not replaced.
/// `urlOf` returns the URLs of the template's own images.
QString filledPage(const ReportTemplate& page, const QHash<QString, QString>& parts,
                   const std::function<QString(std::size_t picture)>& urlOf);

}   // namespace angiopose::app
