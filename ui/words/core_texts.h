#pragma once

#include <QString>

#include <span>
#include <string_view>

namespace angiopose::ui {

/// All that the layers below can say, as templates with %1 … for what they fill in. Collected at build time by
/// resources/translations/collect, which is how they stay free of translations.
std::span<const char* const> coreTexts();

/// What core, io or the command line's texts say, in the language of the window. Finds the template a sentence was made
/// of, also inside a list of sentences or behind the name of a file; unknown words stay as they are.
QString coreText(std::string_view text);
QString coreText(const QString& text);

}   // namespace angiopose::ui