#include "io/dicom/dicom_text.h"

#include <iconv.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace angiopose::io {
namespace {

struct CharacterSet {
    std::string_view term;   ///< defined term of (0008,0005), also with "ISO 2022" in place of "ISO_"
    const char* iconvName;
};

constexpr std::array characterSets = {
    CharacterSet{"IR 100", "ISO-8859-1"}, CharacterSet{"IR 101", "ISO-8859-2"},
    CharacterSet{"IR 109", "ISO-8859-3"}, CharacterSet{"IR 110", "ISO-8859-4"},
    CharacterSet{"IR 144", "ISO-8859-5"}, CharacterSet{"IR 127", "ISO-8859-6"},
    CharacterSet{"IR 126", "ISO-8859-7"}, CharacterSet{"IR 138", "ISO-8859-8"},
    CharacterSet{"IR 148", "ISO-8859-9"}, CharacterSet{"IR 203", "ISO-8859-15"},
    CharacterSet{"IR 166", "TIS-620"},    CharacterSet{"IR 13", "SHIFT_JIS"},
    CharacterSet{"IR 87", "ISO-2022-JP"}, CharacterSet{"IR 159", "ISO-2022-JP-2"},
    CharacterSet{"IR 149", "EUC-KR"},     CharacterSet{"IR 192", "UTF-8"},
    CharacterSet{"GB18030", "GB18030"},   CharacterSet{"GBK", "GBK"},
};

/// The last of several terms is the one that needs more than ASCII.
const char* iconvNameOf(std::string_view terms)
{
    const std::string_view last = terms.substr(terms.rfind('\\') + 1);
    for (const CharacterSet& set : characterSets) {
        if (last.ends_with(set.term)) {
            return set.iconvName;
        }
    }
    return "ISO-8859-1";
}

bool isAscii(std::string_view text)
{
    return std::none_of(text.begin(), text.end(), [](char c) { return (c & 0x80) != 0 || c == '\x1b'; });
}

std::string converted(std::string_view text, const char* from)
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
        if (failed && room > 8 && left > 0) {   // not a matter of room: skip the byte it cannot read
            result += '?';
            ++in;
            --left;
        }
    }
    if (converter != none) {
        iconv_close(converter);
    }
    return result;
}

/// "19700413" → "1970-04-13"; anything else is left out.
std::string dateText(std::string_view date)
{
    const bool isDate =
        date.size() == 8 && std::all_of(date.begin(), date.end(), [](char c) { return c >= '0' && c <= '9'; });
    return isDate ? std::string(date.substr(0, 4)) + "-" + std::string(date.substr(4, 2)) + "-" +
                        std::string(date.substr(6, 2))
                  : std::string();
}

/// "144948.000" → "14:49".
std::string timeText(std::string_view time)
{
    const bool isTime =
        time.size() >= 4 && std::all_of(time.begin(), time.begin() + 4, [](char c) { return c >= '0' && c <= '9'; });
    return isTime ? std::string(time.substr(0, 2)) + ":" + std::string(time.substr(2, 2)) : std::string();
}

}   // namespace

std::string utf8Text(const DicomDataset& data, DicomTag tag)
{
    const std::string_view text = data.text(tag);
    return isAscii(text) ? std::string(text) : converted(text, iconvNameOf(data.text(0x00080005)));
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