#pragma once

#include "app/files/case_report.h"

#include <QImage>

#include <functional>

namespace angiopose::app {

/// Where the page finds a picture.
using PictureUrl = std::function<QString(std::size_t picture)>;

/// The page of a report as HTML. `pictures` are the overlays of its views in their order, then the program's mark;
/// `urlOf` names each of them.
QString reportPage(const CaseReport& report, const std::vector<QImage>& pictures, const PictureUrl& urlOf);

}   // namespace angiopose::app
