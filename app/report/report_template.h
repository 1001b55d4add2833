#pragma once

#include "core/support/result.h"

#include <QHash>
#include <QImage>
#include <QString>

#include <functional>
#include <vector>

namespace angiopose::app {

/// Template of the report page, which the user may customize: HTML with placeholders such as {{views}}.
struct ReportTemplate {
    QString html;   ///< HTML without comments, in which the template's images are placeholders, too
    std::vector<QImage> pictures;
};

QByteArray builtInReportTemplate();   ///< returns the starting point for custom templates

/// Reads a template and the images it names; an empty path selects the built-in template. Fails if the template cannot
/// be read, lacks a required placeholder, contains an unknown one, or names an image that is not in its folder. It
/// reads files, so call it on a worker thread.
core::Result<ReportTemplate> readReportTemplate(const QString& path);

/// Fills in the template. `parts` maps placeholder names to HTML; placeholders inside the parts are not replaced.
/// `urlOf` returns the URL of each of the template's own images.
QString fillTemplate(const ReportTemplate& page, const QHash<QString, QString>& parts,
                     const std::function<QString(std::size_t picture)>& urlOf);

}   // namespace angiopose::app
