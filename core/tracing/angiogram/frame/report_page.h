#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Whether the image is a page of text; dose reports and worksheets are stored among the runs of an examination. Nearly
/// all of the page has one gray value, and most of the rest are letters in rows. All pixels must be finite.
bool isReportPage(const ImageF& picture);

}   // namespace angiopose::core
