#pragma once

#include <string>
#include <vector>

namespace angiopose::ui {

/// A font in its file, which may hold several.
struct FontFace {
    std::string file;   ///< empty: none
    int index = 0;
};

/// For text in pictures: Inter where it is installed, else the system's sans serif.
const FontFace& interfaceFont();

/// One that has the signs the interface font lacks, e.g. Chinese ones; none where nothing on the system has them.
FontFace fontWith(const std::vector<char32_t>& signs);

}   // namespace angiopose::ui