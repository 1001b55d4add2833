#include "ui/scenes/interface_font.h"

#include <fontconfig/fontconfig.h>

namespace ui {
namespace {

std::string findFontFile()
{
    FcPattern* wanted = FcNameParse(reinterpret_cast<const FcChar8*>("Inter,sans-serif:style=Regular:outline=true"));
    FcConfigSubstitute(nullptr, wanted, FcMatchPattern);
    FcDefaultSubstitute(wanted);
    FcResult outcome = FcResultNoMatch;
    FcPattern* found = FcFontMatch(nullptr, wanted, &outcome);
    std::string file;
    FcChar8* name = nullptr;
    if (found && FcPatternGetString(found, FC_FILE, 0, &name) == FcResultMatch) {
        file = reinterpret_cast<const char*>(name);
    }
    if (found) {
        FcPatternDestroy(found);
    }
    FcPatternDestroy(wanted);
    return file;
}

}   // namespace

const std::string& interfaceFontFile()
{
    static const std::string file = findFontFile();
    return file;
}

}   // namespace ui
