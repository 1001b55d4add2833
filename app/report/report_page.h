#pragma once

#include "app/report/case_report.h"
#include "app/report/report_template.h"

#include <QImage>

#include <functional>
#include <vector>

namespace angiopose::app {

/// Returns the URL by which the page refers to an image.
using PictureUrl = std::function<QString(std::size_t picture)>;

/// Images of the report: the overlays of its views in order, then the program's logo, then the images of the template.
using ReportPictures = std::vector<QImage>;

/// Returns the report page as HTML, filled from its template; `urlOf` returns the URL of each image.
QString reportPage(const CaseReport& report, const ReportTemplate& page, const ReportPictures& pictures,
                   const PictureUrl& urlOf);

}   // namespace angiopose::app
