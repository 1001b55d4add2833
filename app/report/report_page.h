#pragma once

#include "app/report/case_report.h"
#include "app/report/report_template.h"

#include <QImage>

#include <functional>
#include <vector>

namespace angiopose::app {

/// URL under which the page finds an image.
using PictureUrl = std::function<QString(std::size_t picture)>;

/// Overlays of the report's views in their order, then the program's logo, then the images of the template.
using ReportPictures = std::vector<QImage>;

/// Report page as HTML, filled from its template; `urlOf` returns the URL of each image.
QString reportPage(const CaseReport& report, const ReportTemplate& page, const ReportPictures& pictures,
                   const PictureUrl& urlOf);

}   // namespace angiopose::app
