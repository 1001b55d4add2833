#pragma once

#include "app/texts/case_texts.h"
#include "core/case/case.h"

#include <QString>
#include <cstddef>
#include <vector>

namespace angiopose::app {

/// Returns the file name (without folder) of a view's image, or of the case file that contains the image.
QString fileNameOf(const core::View& view);

/// Formats the gantry angles, e.g. "LAO 30° · CRA 10°"; returns the file name if the angles are unknown.
QString anglesOf(const core::View& view);

/// Returns the view number, which warnings use, with the user's name or its angles, e.g. "2 · LAO 30° · CRA 10°".
QString numberedTitle(const std::vector<core::View>& views, std::size_t index);

/// Converts corner text to the UI language; see englishTexts.
ui::CornerTexts windowTexts(const CornerLines& lines);

}   // namespace angiopose::app
