#pragma once

#include "app/report/case_report.h"
#include "app/report/report_template.h"

#include <QImage>

#include <functional>
#include <vector>

namespace angiopose::app {

/// Where the page finds a picture.
using PictureUrl = std::function<QString(std::size_t picture)>;

/// The overlays of a report's views in their order, the program's mark, then the pictures of its template.
using ReportPictures = std::vector<QImage>;

/// The page of a report as HTML, by its template; `urlOf` names each of the pictures.
QString reportPage(const CaseReport& report, const ReportTemplate& page, const ReportPictures& pictures,
                   const PictureUrl& urlOf);

}   // namespace angiopose::app
