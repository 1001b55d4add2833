#include "app/texts/printable_text.h"

namespace angiopose::app {
namespace {

bool isCommand(unsigned char byte)
{
    return (byte < ' ' && byte != '\n' && byte != '\t') || byte == 0x7f;
}

/// Returns whether the bytes are a C1 control character (U+0080 … U+009F) in UTF-8. Some terminals interpret U+009B as
/// the start of a control sequence.
bool isLongCommand(unsigned char byte, unsigned char next)
{
    return byte == 0xc2 && next >= 0x80 && next < 0xa0;
}

}   // namespace

std::string printableText(std::string_view text)
{
    std::string shown;
    shown.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (i + 1 < text.size() && isLongCommand(text[i], text[i + 1])) {
            shown += '?';
            ++i;
        } else {
            shown += isCommand(text[i]) ? '?' : text[i];
        }
    }
    return shown;
}

}   // namespace angiopose::app
