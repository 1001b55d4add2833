#include "ui/scenes/text_mask.h"

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace angiopose::ui {
namespace {

struct FontFace {
    std::string file;   ///< path of the font file; empty if there is no font
    int index = 0;
};

/// Returns the font that best matches the pattern; frees the pattern.
FontFace faceFor(FcPattern* pattern)
{
    FcConfigSubstitute(nullptr, pattern, FcMatchPattern);
    FcDefaultSubstitute(pattern);
    FcResult outcome = FcResultNoMatch;
    FcPattern* match = FcFontMatch(nullptr, pattern, &outcome);
    FontFace face;
    FcChar8* name = nullptr;
    if (match && FcPatternGetString(match, FC_FILE, 0, &name) == FcResultMatch) {
        face.file = reinterpret_cast<const char*>(name);
        FcPatternGetInteger(match, FC_INDEX, 0, &face.index);
    }
    if (match) {
        FcPatternDestroy(match);
    }
    FcPatternDestroy(pattern);
    return face;
}

FcPattern* patternOf(const char* name)
{
    return FcNameParse(reinterpret_cast<const FcChar8*>(name));
}

/// Returns the font for text in images: Inter if it is installed, otherwise the sans-serif font of the system.
const FontFace& interfaceFont()
{
    static const FontFace face = faceFor(patternOf("Inter,sans-serif:style=Regular:outline=true"));
    return face;
}

/// Returns a fallback font for characters that the interface font lacks, e.g. Chinese.
FontFace fontWith(const std::vector<char32_t>& signs)
{
    FcPattern* pattern = patternOf("sans-serif:style=Regular:outline=true:lang=zh-cn");
    FcCharSet* needed = FcCharSetCreate();
    for (const char32_t sign : signs) {
        FcCharSetAddChar(needed, sign);
    }
    FcPatternAddCharSet(pattern, FC_CHARSET, needed);
    FcCharSetDestroy(needed);
    return faceFor(pattern);
}

struct FreeFace {
    void operator()(FT_Face face) const { FT_Done_Face(face); }
};
struct FreeLibrary {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};
using Library = std::unique_ptr<FT_LibraryRec_, FreeLibrary>;
using Face = std::unique_ptr<FT_FaceRec_, FreeFace>;

Library openLibrary()
{
    FT_Library library = nullptr;
    return Library(FT_Init_FreeType(&library) == 0 ? library : nullptr);
}

Face openFace(const Library& library, const FontFace& font, int sizePx)
{
    FT_Face face = nullptr;
    if (!library || font.file.empty() || FT_New_Face(library.get(), font.file.c_str(), font.index, &face) != 0) {
        return {};
    }
    FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(sizePx));
    return Face(face);
}

/// Decodes UTF-8 to code points; an invalid sequence ends the text.
std::vector<char32_t> codePoints(const std::string& text)
{
    std::vector<char32_t> points;
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t length = lead < 0x80 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
        if (i + length > text.size()) {
            break;
        }
        char32_t point = length == 1 ? lead : lead & (0x7fU >> length);
        for (std::size_t k = 1; k < length; ++k) {
            point = point << 6U | (static_cast<unsigned char>(text[i + k]) & 0x3fU);
        }
        points.push_back(point);
        i += length;
    }
    return points;
}

void addGlyph(core::Mask2d& mask, const FT_GlyphSlot glyph, int penX, int baseline)
{
    const FT_Bitmap& bitmap = glyph->bitmap;
    for (unsigned row = 0; row < bitmap.rows; ++row) {
        for (unsigned column = 0; column < bitmap.width; ++column) {
            const int x = penX + glyph->bitmap_left + static_cast<int>(column);
            const int y = baseline - glyph->bitmap_top + static_cast<int>(row);
            if (mask.contains(x, y)) {
                const auto coverage = bitmap.buffer[row * static_cast<unsigned>(bitmap.pitch) + column];
                mask.at(x, y) = std::max(mask.at(x, y), coverage);
            }
        }
    }
}

/// Interface font with a fallback font for missing characters.
class Fonts {
public:
    Fonts(const std::vector<std::string>& lines, int sizePx)
        : library_(openLibrary()), usual_(openFace(library_, interfaceFont(), sizePx))
    {
        std::vector<char32_t> missing;
        for (const std::string& line : lines) {
            std::ranges::copy_if(codePoints(line), std::back_inserter(missing),
                                 [this](char32_t sign) { return usual_ && !has(usual_, sign); });
        }
        if (!missing.empty()) {
            other_ = openFace(library_, fontWith(missing), sizePx);
        }
    }
    explicit operator bool() const { return usual_ != nullptr; }

    /// Loads the glyph of a character, and renders it if `flags` request it; null if neither font has the character.
    FT_GlyphSlot glyph(char32_t sign, FT_Int32 flags) const
    {
        const Face& face = other_ && !has(usual_, sign) ? other_ : usual_;
        return FT_Load_Char(face.get(), sign, flags) == 0 ? face->glyph : nullptr;
    }

private:
    static bool has(const Face& face, char32_t sign) { return FT_Get_Char_Index(face.get(), sign) != 0; }

    Library library_;
    Face usual_;
    Face other_;
};

int widthOf(const Fonts& fonts, const std::string& line)
{
    int width = 0;
    for (const char32_t sign : codePoints(line)) {
        if (const FT_GlyphSlot glyph = fonts.glyph(sign, FT_LOAD_DEFAULT)) {
            width += static_cast<int>(glyph->advance.x >> 6);
        }
    }
    return width;
}

}   // namespace

core::Mask2d textMask(const std::vector<std::string>& lines, int sizePx, TextAlign align)
{
    const Fonts fonts(lines, sizePx);
    if (!fonts || lines.empty()) {
        return {};
    }
    const int lineHeight = static_cast<int>(std::lround(1.4 * sizePx));
    int width = 0;
    for (const std::string& line : lines) {
        width = std::max(width, widthOf(fonts, line));
    }
    core::Mask2d mask(width + 2, lineHeight * static_cast<int>(lines.size()));
    int baseline = static_cast<int>(std::lround(1.05 * sizePx));
    for (const std::string& line : lines) {
        int penX = align == TextAlign::Right ? width - widthOf(fonts, line) : 0;
        for (const char32_t sign : codePoints(line)) {
            if (const FT_GlyphSlot glyph = fonts.glyph(sign, FT_LOAD_RENDER)) {
                addGlyph(mask, glyph, penX, baseline);
                penX += static_cast<int>(glyph->advance.x >> 6);
            }
        }
        baseline += lineHeight;
    }
    return mask;
}

}   // namespace angiopose::ui
