#include "io/deidentify/permitted_elements.h"

#include "io/dicom/new_uid.h"
#include "io/messages/messages.h"
#include "io/support/numbers.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <openssl/rand.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace angiopose::io {
namespace {

constexpr std::size_t keyBytes = 32;
constexpr std::string_view rootOfDicom = "1.2.840.10008.";
constexpr int minWeeks = 52;
constexpr int moreWeeks = 468;

unsigned numberOf(std::string_view bytes)
{
    unsigned number = 0;
    for (const char byte : bytes.substr(0, 4)) {
        number = number << 8U | static_cast<unsigned char>(byte);
    }
    return number;
}

/// Groups that describe the image: acquisition, relationship, image, nuclear medicine and rotation, display, functional
/// groups.
constexpr std::array<DicomTag, 6> describingGroups{0x0018, 0x0020, 0x0028, 0x0054, 0x2050, 0x5200};

/// Elements of group 0008 that are kept: image type, creation time, referenced images, cine playback.
constexpr std::array<DicomTag, 24> keptOfIdentification{
    0x00080008, 0x00080016, 0x00080018, 0x00080020, 0x00080021, 0x00080022, 0x00080023, 0x0008002a,
    0x00080030, 0x00080031, 0x00080032, 0x00080033, 0x00080060, 0x00080064, 0x00080068, 0x00081140,
    0x00081150, 0x00081155, 0x00082112, 0x00082142, 0x00082143, 0x00082144, 0x00089007, 0x00089205};

/// Short strings that are kept: the stack ID of an image; manufacturer and model, which determine the angle convention.
constexpr DicomTag stackTag = 0x00209056;
constexpr std::array<DicomTag, 2> keptNames{0x00080070, 0x00081090};
constexpr DicomTag rescaleTypeTag = 0x00281054;   ///< the value is a defined term, although the VR permits free text
constexpr DicomTag lookUpTableTag = 0x00283006;
constexpr std::size_t maxNameLetters = 64;

const DcmTagKey codeValueTag(0x0008, 0x0100);
const DcmTagKey codeSchemeTag(0x0008, 0x0102);
const DcmTagKey codeMeaningTag(0x0008, 0x0104);
const DcmTagKey longCodeValueTag(0x0008, 0x0119);

DicomTag tagOf(DcmElement& element)
{
    return static_cast<DicomTag>(element.getGTag()) << 16U | element.getETag();
}

std::string textOf(DcmElement& element)
{
    char* bytes = nullptr;
    Uint32 size = 0;
    return element.getString(bytes, size).good() && bytes ? std::string(trimmed({bytes, size})) : std::string();
}

std::vector<std::string> valuesOf(const std::string& text)
{
    std::vector<std::string> values(1);
    for (const char c : text) {
        if (c == '\\') {
            values.emplace_back();
        } else {
            values.back() += c;
        }
    }
    for (std::string& value : values) {
        value = trimmed(value);
    }
    return values;
}

template <class Each>
std::string joined(const std::vector<std::string>& values, const Each& each)
{
    std::string text;
    for (std::size_t n = 0; n < values.size(); ++n) {
        text += (n == 0 ? "" : "\\") + each(values[n]);
    }
    return text;
}

bool isNumber(const std::string& value)
{
    return value.empty() || parseNumber(value).has_value();
}

bool isCode(const std::string& value)
{
    return value.size() <= 16 && std::ranges::all_of(value, [](char c) {
               return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' || c == '_';
           });
}

bool isName(const std::string& value)
{
    return value.size() <= maxNameLetters && std::ranges::all_of(value, [](char c) {
               return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
                      std::string_view(" -._/()+").find(c) != std::string_view::npos;
           });
}

bool isKeptLongString(DicomTag tag, const std::vector<std::string>& values)
{
    return tag == rescaleTypeTag
               ? std::ranges::all_of(values, isCode)
               : std::ranges::find(keptNames, tag) != keptNames.end() && std::ranges::all_of(values, isName);
}

class Copier {
public:
    explicit Copier(const Replacements& replacements) : replacements_(replacements) {}

    void copyAll(DcmItem& from, DcmItem& to) const
    {
        for (unsigned long n = 0; n < from.card(); ++n) {
            DcmElement& element = *from.getElement(n);
            if (isWanted(tagOf(element)) && !to.tagExists(element.getTag())) {
                copy(element, to);
            }
        }
    }

private:
    bool isWanted(DicomTag tag) const
    {
        return isDescribing(tag) || (replacements_.content != nullptr && ContentCleaner::has(tag));
    }

    static bool isDescribing(DicomTag tag)
    {
        return std::ranges::find(describingGroups, tag >> 16U) != describingGroups.end() ||
               std::ranges::find(keptOfIdentification, tag) != keptOfIdentification.end() ||
               std::ranges::find(keptNames, tag) != keptNames.end();
    }

    void copy(DcmElement& element, DcmItem& to) const
    {
        switch (element.ident()) {
            case EVR_SQ:
                copySequence(static_cast<DcmSequenceOfItems&>(element), to);
                break;
            case EVR_US:
            case EVR_SS:
            case EVR_UL:
            case EVR_SL:
            case EVR_FL:
            case EVR_FD:
            case EVR_AT:
                take(element, to);
                break;
            case EVR_OW:
            case EVR_OB:
                if (tagOf(element) == lookUpTableTag) {
                    take(element, to);
                }
                break;
            default:
                copyText(element, to);
        }
    }

    static void take(const DcmElement& element, DcmItem& to)
    {
        to.insert(static_cast<DcmElement*>(element.clone()), OFTrue);
    }

    void copySequence(DcmSequenceOfItems& sequence, DcmItem& to) const
    {
        auto kept = std::make_unique<DcmSequenceOfItems>(sequence.getTag());
        for (unsigned long n = 0; n < sequence.card(); ++n) {
            auto item = std::make_unique<DcmItem>();
            if (replacements_.content != nullptr && isTerm(*sequence.getItem(n))) {
                copyTerm(*sequence.getItem(n), *item);
            } else {
                copyAll(*sequence.getItem(n), *item);
            }
            kept->append(item.release());   // append empty items too, because references count items
        }
        const bool isEmpty = [&] {
            for (unsigned long n = 0; n < kept->card(); ++n) {
                if (kept->getItem(n)->card() > 0) {
                    return false;
                }
            }
            return true;
        }();
        if (!isEmpty) {
            to.insert(kept.release(), OFTrue);
        }
    }

    static bool isTerm(DcmItem& item) { return item.tagExists(codeValueTag) || item.tagExists(longCodeValueTag); }

    void copyTerm(DcmItem& from, DcmItem& to) const
    {
        const auto read = [&from](const DcmTagKey& tag) {
            OFString value;
            return from.findAndGetOFString(tag, value).good() ? std::string(trimmed(value.c_str())) : std::string();
        };
        const CodedEntry kept =
            replacements_.content->term({read(codeValueTag), read(codeSchemeTag), read(codeMeaningTag)});
        to.putAndInsertString(DcmTag(codeValueTag, EVR_SH), kept.value.c_str());
        to.putAndInsertString(DcmTag(codeSchemeTag, EVR_SH), kept.scheme.c_str());
        to.putAndInsertString(DcmTag(codeMeaningTag, EVR_LO), kept.meaning.c_str());
    }

    void copyText(DcmElement& element, DcmItem& to) const
    {
        const DicomTag tag = tagOf(element);
        const std::vector<std::string> values = valuesOf(textOf(element));
        auto text = replacements_.content != nullptr && ContentCleaner::isReplaced(tag)
                        ? std::optional(replacements_.content->replacementFor(tag, values))
                        : kept(element, values);
        if (!text && replacements_.content != nullptr) {
            text = ContentCleaner::replacementForTime(tag, DcmVR(element.getVR()).getVRName());
        }
        if (text) {
            to.putAndInsertString(DcmTag(element.getTag(), DcmVR(element.getVR())), text->c_str());
        }
    }

    /// Returns the de-identified value; nullopt if the element must be removed.
    std::optional<std::string> kept(DcmElement& element, const std::vector<std::string>& values) const
    {
        const auto as = [&](bool mayStay) {
            const std::string whole = joined(values, [](const std::string& value) { return value; });
            return mayStay && !replacements_.words.occurIn(whole) ? std::optional(whole) : std::nullopt;
        };
        switch (element.ident()) {
            case EVR_DS:
            case EVR_IS:
                return as(std::ranges::all_of(values, isNumber));
            case EVR_CS:
                return as(std::ranges::all_of(values, isCode));
            case EVR_UI:
                return values == std::vector<std::string>{""}
                           ? std::nullopt
                           : std::optional(joined(
                                 values, [this](const std::string& uid) { return replacements_.pseudonyms.uid(uid); }));
            case EVR_DA:
            case EVR_DT:
            case EVR_TM:
                return replacements_.dates == DatePolicy::Shifted ? shifted(element.ident(), values) : std::nullopt;
            case EVR_SH:
                return as(tagOf(element) == stackTag && values.size() == 1 && isNumber(values[0]));
            case EVR_LO:
                return as(isKeptLongString(tagOf(element), values));
            default:
                return std::nullopt;
        }
    }

    /// Shifts dates and keeps times of day (PS3.15, Retain Longitudinal Temporal Information with Modified Dates).
    std::optional<std::string> shifted(DcmEVR vr, const std::vector<std::string>& values) const
    {
        const std::string text = joined(values, [&](const std::string& value) -> std::string {
            if (vr == EVR_TM) {
                return parseNumber(value) ? value : std::string();
            }
            const std::string date = replacements_.pseudonyms.date(value.substr(0, 8), replacements_.patient);
            const std::string rest = vr == EVR_DT && value.size() > 8 ? value.substr(8) : std::string();
            return date.empty() || !parseNumber(rest.substr(0, rest.find_first_of("+-")).insert(0, "0")) ? std::string()
                                                                                                         : date + rest;
        });
        return text.empty() ? std::nullopt : std::optional(text);
    }

    const Replacements& replacements_;
};

}   // namespace

core::Result<Pseudonyms> Pseudonyms::create()
{
    std::array<unsigned char, keyBytes> bytes{};
    if (RAND_bytes(bytes.data(), keyBytes) != 1) {
        return core::Error(messages::noRandomKey());
    }
    return Pseudonyms(std::string(bytes.begin(), bytes.end()));
}

std::string Pseudonyms::digest(std::string_view role, std::string_view original) const
{
    const std::string text = std::string(role) + '\0' + std::string(original);
    std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
    unsigned int size = 0;
    HMAC(EVP_sha256(), key_.data(), static_cast<int>(key_.size()), reinterpret_cast<const unsigned char*>(text.data()),
         text.size(), bytes.data(), &size);
    return {reinterpret_cast<const char*>(bytes.data()), size};
}

std::string Pseudonyms::uid(std::string_view original) const
{
    return original.starts_with(rootOfDicom) ? std::string(original) : uidFromContent(digest("uid", original));
}

std::string Pseudonyms::patient(std::string_view original) const
{
    std::array<char, 16> text{};
    const std::string bytes = digest("patient", original);
    std::snprintf(text.data(), text.size(), "P-%08X%02X", numberOf(bytes), numberOf(bytes.substr(4)) & 0xffU);
    return text.data();
}

std::string Pseudonyms::date(std::string_view original, std::string_view patient) const
{
    using namespace std::chrono;
    const auto number = original.size() == 8 ? parseNumber(original) : std::nullopt;
    const int digits = number ? static_cast<int>(*number) : 0;
    const year_month_day date{year(digits / 10000), month(static_cast<unsigned>(digits / 100 % 100)),
                              day(static_cast<unsigned>(digits % 100))};
    if (digits <= 0 || !date.ok()) {
        return {};
    }
    const weeks earlier(minWeeks + static_cast<int>(numberOf(digest("date", patient)) % moreWeeks));
    const year_month_day shifted(sys_days(date) - earlier);
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%04d%02u%02u", static_cast<int>(shifted.year()),
                  static_cast<unsigned>(shifted.month()), static_cast<unsigned>(shifted.day()));
    return text.data();
}

void copyPermittedElements(const DicomDataset& from, DicomItem& to, const Replacements& replacements)
{
    for (const std::shared_ptr<DcmItem>& layer : from.layers()) {
        Copier(replacements).copyAll(*layer, to.element());
    }
}

}   // namespace angiopose::io
