#pragma once

#include "app/texts/case_texts.h"
#include "core/case/case.h"

#include <QString>
#include <cstddef>
#include <vector>

namespace angiopose::app {

/// File name, without folder, of the image of a view or of the case file that contains it.
QString fileNameOf(const core::View& view);

/// "LAO 30° · CRA 10°"; the file name if the angles are unknown.
QString anglesOf(const core::View& view);

/// "2 · LAO 30° · CRA 10°", or the user's name for the view after its number, which warnings refer to.
QString numberedTitle(const std::vector<core::View>& views, std::size_t place);

/// Corner lines in the language of the window, see englishTexts.
ui::CornerTexts windowTexts(const CornerLines& lines);

}   // namespace angiopose::app
