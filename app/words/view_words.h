#pragma once

#include "app/texts/case_texts.h"
#include "core/case/case.h"

#include <QString>
#include <cstddef>
#include <vector>

namespace angiopose::app {

/// Of the image of a view, or of the case file that it stands in, without its folder.
QString fileNameOf(const core::View& view);

/// "LAO 30° · CRA 10°"; the file where the angles are not known.
QString anglesOf(const core::View& view);

/// "2 · LAO 30° · CRA 10°", or the name that the user gave: by its number warnings name it.
QString numberedTitle(const std::vector<core::View>& views, std::size_t place);

/// Corner lines in the language of the window, see englishTexts.
ui::CornerTexts windowTexts(const CornerLines& lines);

}   // namespace angiopose::app
