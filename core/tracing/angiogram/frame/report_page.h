#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// True for a page of text: dose reports and worksheets are stored among the runs of an examination. Nearly all of it
/// is of one grey value, and most of the rest are letters in rows. The picture must be finite.
bool isReportPage(const ImageF& picture);

}   // namespace angiopose::core
