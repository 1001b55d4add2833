#include "io/dicom/dicom_text.h"

#include "io/support/numbers.h"

#include <iconv.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace angiopose::io {
namespace {

struct CharacterSet {
    std::string_view term;   ///< defined term of (0008,0005); also valid with "ISO 2022" instead of "ISO_"
    const char* iconvName;
    std::string_view escape;   ///< characters that follow ESC to switch to this set within a string (PS3.3 C.12.1.1.2)
};

constexpr std::array characterSets = {
    CharacterSet{"IR 100", "ISO-8859-1", "-A"},
    CharacterSet{"IR 101", "ISO-8859-2", "-B"},
    CharacterSet{"IR 109", "ISO-8859-3", "-C"},
    CharacterSet{"IR 110", "ISO-8859-4", "-D"},
    CharacterSet{"IR 144", "ISO-8859-5", "-L"},
    CharacterSet{"IR 127", "ISO-8859-6", "-G"},
    CharacterSet{"IR 126", "ISO-8859-7", "-F"},
    CharacterSet{"IR 138", "ISO-8859-8", "-H"},
    CharacterSet{"IR 148", "ISO-8859-9", "-M"},
    CharacterSet{"IR 203", "ISO-8859-15", "-b"},
    CharacterSet{"IR 166", "TIS-620", "-T"},
    CharacterSet{"IR 13", "SHIFT_JIS", ")I"},
    CharacterSet{"IR 87", "ISO-2022-JP", "$B"},
    CharacterSet{"IR 159", "ISO-2022-JP-2", "$(D"},
    CharacterSet{"IR 149", "EUC-KR", "$)C"},
    CharacterSet{"IR 58", "GB2312", "$)A"},
    CharacterSet{"IR 192", "UTF-8", "%G"},
    CharacterSet{"GB18030", "GB18030", {}},
    CharacterSet{"GBK", "GBK", {}},
};

/// Finds a character set by its defined term; returns null for ASCII and unknown terms.
const CharacterSet* findCharacterSet(std::string_view term)
{
    const auto* found = std::ranges::find_if(
        characterSets, [term](const CharacterSet& set) { return trimmed(term).ends_with(set.term); });
    return found == characterSets.end() ? nullptr : found;
}

bool isAscii(std::string_view text)
{
    return std::none_of(text.begin(), text.end(), [](char c) { return (c & 0x80) != 0 || c == '\x1b'; });
}

std::string converted(std::string_view text, const char* from, std::string_view unreadable = "?")
{
    const auto none = std::bit_cast<iconv_t>(std::intptr_t{-1});
    const iconv_t converter = iconv_open("UTF-8", from);
    std::string result;
    std::array<char, 256> block;
    char* in = const_cast<char*>(text.data());
    std::size_t left = text.size();
    while (left > 0 && converter != none) {
        char* out = block.data();
        std::size_t room = block.size();
        const bool failed = iconv(converter, &in, &left, &out, &room) == static_cast<std::size_t>(-1);
        result.append(block.data(), block.size() - room);
        if (failed && room > 8 && left > 0) {   // the buffer is not full, so the byte cannot be converted: skip it
            result += unreadable;
            ++in;
            --left;
        }
    }
    if (converter != none) {
        iconv_close(converter);
    }
    return result;
}

/// Returns whether a set encodes characters as two bytes below 0x80, as ASCII does unless an escape sequence precedes.
bool isDoubleByte(const CharacterSet& set)
{
    return set.escape == "$B" || set.escape == "$(D";
}

bool isUtf8(std::string_view text)
{
    return converted(text, "UTF-8", "\xff").find('\xff') == std::string::npos;
}

/// Converts bytes from one character set. If the set is unknown, tries UTF-8, then Latin-1.
std::string decodeWithCharacterSet(std::string_view bytes, const CharacterSet* set)
{
    const bool isGuess = !set || set->term == "IR 192" || isDoubleByte(*set);
    return converted(bytes, isGuess ? isUtf8(bytes) ? "UTF-8" : "ISO-8859-1" : set->iconvName);
}

/// Converts a string that switches character sets by escape sequences (PS3.5 6.1.2.5). After a delimiter, the first set
/// applies again; if that set is ASCII only, non-ASCII bytes belong to the previous set.
std::string decodeWithEscapes(std::string_view text, const CharacterSet* first)
{
    std::string result;
    const CharacterSet* upper = first;   // character set for bytes from 0x80
    const CharacterSet* pairs = nullptr;   // active two-byte set for bytes below 0x80
    std::size_t begin = 0;
    const auto flush = [&](std::size_t end) {
        const std::string_view bytes = text.substr(begin, end - begin);
        result += pairs ? converted("\x1b" + std::string(pairs->escape) + std::string(bytes), pairs->iconvName)
                  : isAscii(bytes) ? std::string(bytes)
                                   : decodeWithCharacterSet(bytes, upper);
        begin = end;
    };
    for (std::size_t at = 0; at < text.size(); ++at) {
        const bool isDelimiter = std::string_view("^=\\\r\n\f\t").find(text[at]) != std::string_view::npos;
        if (text[at] != '\x1b') {
            if (isDelimiter && !pairs && first) {
                flush(at);
                upper = first;
            }
            continue;
        }
        flush(at);
        const std::string_view rest = text.substr(at + 1);
        const auto* set = std::ranges::find_if(characterSets, [rest](const CharacterSet& each) {
            return !each.escape.empty() && rest.starts_with(each.escape);
        });
        std::size_t intermediate = 0;   // bytes before the final one, also of unknown sequences
        while (intermediate < rest.size() && rest[intermediate] >= ' ' && rest[intermediate] <= '/') {
            ++intermediate;
        }
        if (set != characterSets.end() && !isDoubleByte(*set)) {
            upper = set;
        } else {
            pairs = set != characterSets.end()
                        ? set
                        : findCharacterSet(rest.starts_with("$@") ? "IR 87" : "");   // "$@": the 1978 edition
        }
        at += std::min(intermediate + 1, rest.size());
        begin = at + 1;
    }
    flush(text.size());
    return result;
}

/// Converts "19700413" to "1970-04-13"; returns an empty string for anything else.
std::string dateText(std::string_view date)
{
    const bool isDate =
        date.size() == 8 && std::all_of(date.begin(), date.end(), [](char c) { return c >= '0' && c <= '9'; });
    return isDate ? std::string(date.substr(0, 4)) + "-" + std::string(date.substr(4, 2)) + "-" +
                        std::string(date.substr(6, 2))
                  : std::string();
}

/// Converts "144948.000" to "14:49".
std::string timeText(std::string_view time)
{
    const bool isTime =
        time.size() >= 4 && std::all_of(time.begin(), time.begin() + 4, [](char c) { return c >= '0' && c <= '9'; });
    return isTime ? std::string(time.substr(0, 2)) + ":" + std::string(time.substr(2, 2)) : std::string();
}

}   // namespace

std::string utf8Text(const DicomDataset& data, DicomTag tag, std::string_view declared)
{
    const std::string_view text = data.text(tag);
    if (isAscii(text)) {
        return std::string(text);
    }
    const std::string_view own = data.text(0x00080005);
    const std::string_view terms = own.empty() ? declared : own;
    const CharacterSet* first = findCharacterSet(terms.substr(0, terms.find('\\')));
    if (text.find('\x1b') != std::string_view::npos) {
        return decodeWithEscapes(text, first);
    }
    return decodeWithCharacterSet(text, first ? first : findCharacterSet(terms.substr(terms.rfind('\\') + 1)));
}

core::StudyIdentity identityOf(const DicomDataset& data)
{
    core::StudyIdentity identity;
    identity.patientName = utf8Text(data, 0x00100010);
    identity.patientId = utf8Text(data, 0x00100020);
    identity.birthDate = dateText(data.text(0x00100030));
    identity.sex = utf8Text(data, 0x00100040);
    identity.accessionNumber = utf8Text(data, 0x00080050);
    identity.laterality = utf8Text(data, data.text(0x00200062).empty() ? 0x00200060 : 0x00200062);
    identity.institution = utf8Text(data, 0x00080080);
    identity.studyDate = dateText(data.text(0x00080020));
    identity.studyTime = timeText(data.text(0x00080030));
    identity.modality = utf8Text(data, 0x00080060);
    identity.manufacturer = utf8Text(data, 0x00080070);
    identity.description = utf8Text(data, 0x0008103e);
    if (identity.description.empty()) {
        identity.description = utf8Text(data, 0x00081030);
    }
    identity.studyUid = utf8Text(data, 0x0020000d);
    identity.seriesUid = utf8Text(data, 0x0020000e);
    identity.sopInstanceUid = utf8Text(data, 0x00080018);
    return identity;
}

}   // namespace angiopose::io
