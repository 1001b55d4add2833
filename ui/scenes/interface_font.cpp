#include "ui/scenes/interface_font.h"

#include <fontconfig/fontconfig.h>

namespace angiopose::ui {
namespace {

/// The best match; takes the pattern over.
FontFace faceFor(FcPattern* wanted)
{
    FcConfigSubstitute(nullptr, wanted, FcMatchPattern);
    FcDefaultSubstitute(wanted);
    FcResult outcome = FcResultNoMatch;
    FcPattern* found = FcFontMatch(nullptr, wanted, &outcome);
    FontFace face;
    FcChar8* name = nullptr;
    if (found && FcPatternGetString(found, FC_FILE, 0, &name) == FcResultMatch) {
        face.file = reinterpret_cast<const char*>(name);
        FcPatternGetInteger(found, FC_INDEX, 0, &face.index);
    }
    if (found) {
        FcPatternDestroy(found);
    }
    FcPatternDestroy(wanted);
    return face;
}

FcPattern* patternOf(const char* name)
{
    return FcNameParse(reinterpret_cast<const FcChar8*>(name));
}

}   // namespace

const FontFace& interfaceFont()
{
    static const FontFace face = faceFor(patternOf("Inter,sans-serif:style=Regular:outline=true"));
    return face;
}

FontFace fontWith(const std::vector<char32_t>& signs)
{
    FcPattern* wanted = patternOf("sans-serif:style=Regular:outline=true:lang=zh-cn");
    FcCharSet* needed = FcCharSetCreate();
    for (const char32_t sign : signs) {
        FcCharSetAddChar(needed, sign);
    }
    FcPatternAddCharSet(wanted, FC_CHARSET, needed);
    FcCharSetDestroy(needed);
    return faceFor(wanted);
}

}   // namespace angiopose::ui