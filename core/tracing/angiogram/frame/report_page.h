#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Returns whether the image is a page of text, such as a dose report or worksheet stored among the runs of an
/// examination: most pixels have one gray value, and most other shapes are letters in rows. All pixels must be finite.
bool isReportPage(const ImageF& image);

}   // namespace angiopose::core
