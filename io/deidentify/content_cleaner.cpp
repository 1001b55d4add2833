#include "io/deidentify/content_cleaner.h"

#include "io/dicom/objects/coded_term.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string_view>

namespace angiopose::io {
namespace {

constexpr CodedTerm takenOut{"AP0", "99ANGIOPOSE", "Term that was taken out"};

/// Terms in the objects that AngioPose creates; a test verifies that the list is complete.
constexpr std::array knownTerms{
    CodedTerm{"111028", "DCM", "Image Library"},
    CodedTerm{"112039", "DCM", "Tracking Identifier"},
    CodedTerm{"112040", "DCM", "Tracking Unique Identifier"},
    CodedTerm{"113076", "DCM", "Segmentation"},
    CodedTerm{"121005", "DCM", "Observer Type"},
    CodedTerm{"121007", "DCM", "Device"},
    CodedTerm{"121012", "DCM", "Device Observer UID"},
    CodedTerm{"121013", "DCM", "Device Observer Name"},
    CodedTerm{"121015", "DCM", "Device Observer Model Name"},
    CodedTerm{"121049", "DCM", "Language of Content Item and Descendants"},
    CodedTerm{"121058", "DCM", "Procedure reported"},
    CodedTerm{"121106", "DCM", "Comment"},
    CodedTerm{"121322", "DCM", "Source image for image processing operation"},
    CodedTerm{"125007", "DCM", "Measurement Group"},
    CodedTerm{"125024", "DCM", "Image Content-based Alignment"},
    CodedTerm{"126000", "DCM", "Imaging Measurement Report"},
    CodedTerm{"126010", "DCM", "Imaging Measurements"},
    CodedTerm{"126200", "DCM", "Image Library Group"},
    CodedTerm{"123037004", "SCT", "Anatomical Structure"},
    CodedTerm{"42798000", "SCT", "Area"},
    CodedTerm{"1483009", "SCT", "Angle"},
    CodedTerm{"410668003", "SCT", "Length"},
    CodedTerm{"51114001", "SCT", "Artery"},
    CodedTerm{"77343006", "SCT", "Angiography"},
    CodedTerm{"en-US", "RFC5646", "English (United States)"},
    CodedTerm{"1", "UCUM", "no units"},
    CodedTerm{"deg", "UCUM", "degree"},
    CodedTerm{"mm", "UCUM", "millimeter"},
    CodedTerm{"mm2", "UCUM", "square millimeter"},
    CodedTerm{"{pixels}", "UCUM", "pixels"},
    CodedTerm{"{pixels2}", "UCUM", "square pixels"},
    CodedTerm{"AP1", "99ANGIOPOSE", "Median distance, projected to seen vessels, image"},
    CodedTerm{"AP2", "99ANGIOPOSE", "Median distance, projected to seen vessels"},
    CodedTerm{"AP3", "99ANGIOPOSE", "95th percentile of distance to seen vessels"},
    CodedTerm{"AP4", "99ANGIOPOSE", "Share of seen vessels near projected vessels"},
    CodedTerm{"AP5", "99ANGIOPOSE", "Probability that the overlay lies within 2 mm"},
    CodedTerm{"AP6", "99ANGIOPOSE", "Standard error across the rays"},
    CodedTerm{"AP7", "99ANGIOPOSE", "Standard error along the rays"},
    CodedTerm{"AP8", "99ANGIOPOSE", "Registration method"},
    CodedTerm{"AP9", "99ANGIOPOSE", "Judgement of the registration"},
};

/// Permitted units. The list is closed because a unit in braces may be any text and a name may look like a unit.
constexpr std::array<std::string_view, 32> knownUnits{
    "%",  "1",   "cm",  "cm2", "cm3", "deg",      "g",         "Gy",      "Gy.m2",    "Gy.cm2", "dGy.m2",
    "h",  "Hz",  "keV", "kg",  "kV",  "m",        "mA",        "mAs",     "mGy",      "mL",     "ml",
    "mm", "mm2", "mm3", "ms",  "min", "{pixels}", "{pixels2}", "{ratio}", "[hnsf'U]", "s"};

bool isCodeDigit(char c)
{
    return c >= '0' && c <= '9';
}

bool isNumberOf(std::string_view value, std::size_t least, std::size_t most)
{
    return value.size() >= least && value.size() <= most && std::ranges::all_of(value, isCodeDigit);
}

/// Returns whether `value` has the format of a SNOMED 3 code, for example "T-D0050" or "R-10241".
bool isSnomedThree(std::string_view value)
{
    const bool isHex = std::ranges::all_of(value.substr(std::min<std::size_t>(value.size(), 2)),
                                           [](char c) { return isCodeDigit(c) || (c >= 'A' && c <= 'F'); });
    return value.size() >= 6 && value.size() <= 8 && value[0] >= 'A' && value[0] <= 'Z' && value[1] == '-' && isHex;
}

/// Returns whether `value` has the format of a LOINC code, for example "18745-0".
bool isLoinc(std::string_view value)
{
    return value.size() >= 4 && value.size() <= 8 && value[value.size() - 2] == '-' && isCodeDigit(value.back()) &&
           isNumberOf(value.substr(0, value.size() - 2), 2, 6);
}

/// Returns whether `value` has the format of a language code, for example "en" or "en-US".
bool isLanguage(std::string_view value)
{
    const auto areBetween = [](std::string_view letters, char first, char last) {
        return std::ranges::all_of(letters, [&](char c) { return c >= first && c <= last; });
    };
    return (value.size() == 2 && areBetween(value, 'a', 'z')) ||
           (value.size() == 5 && areBetween(value.substr(0, 2), 'a', 'z') && value[2] == '-' &&
            areBetween(value.substr(3), 'A', 'Z'));
}

bool isUnit(std::string_view value)
{
    return std::ranges::find(knownUnits, value) != knownUnits.end();
}

/// Public coding scheme and the format of its code values.
struct PublicScheme {
    std::string_view name;
    bool (*isValue)(std::string_view value);
};
constexpr std::array<PublicScheme, 9> publicSchemes{{
    {"DCM", [](std::string_view value) { return isNumberOf(value, 6, 6); }},
    {"SCT", [](std::string_view value) { return isNumberOf(value, 6, 16); }},
    {"SRT", isSnomedThree},
    {"SNM3", isSnomedThree},
    {"99SDM", isSnomedThree},
    {"FMA", [](std::string_view value) { return isNumberOf(value, 3, 6); }},
    {"LN", isLoinc},
    {"UCUM", isUnit},
    {"RFC5646", isLanguage},
}};

const CodedTerm* knownTerm(const CodedEntry& term)
{
    const auto found = std::ranges::find_if(
        knownTerms, [&](const CodedTerm& known) { return term.value == known.value && term.scheme == known.scheme; });
    return found == knownTerms.end() ? nullptr : &*found;
}

enum class ContentRule {
    AsUsual,   ///< the general rules apply: sequences, numbers, codes, UIDs
    Empty,
    Label,
    Layer,
    SegmentLabel,
    Algorithm,
    Words,
    Name,
    Unverified,
    Template,
    Time
};

struct ContentElement {
    DicomTag tag;
    ContentRule rule = ContentRule::AsUsual;
};

constexpr std::array contentElements{
    // Creation time and references.
    ContentElement{0x00080023, ContentRule::Time}, ContentElement{0x00080033, ContentRule::Time},
    ContentElement{0x00081115}, ContentElement{0x0008114a}, ContentElement{0x00081160}, ContentElement{0x00081199},
    ContentElement{0x00089124}, ContentElement{0x00089215}, ContentElement{0x0040a170},
    // Segments (PS3.3 C.8.20.2).
    ContentElement{0x00620001}, ContentElement{0x00620002}, ContentElement{0x00620003}, ContentElement{0x00620004},
    ContentElement{0x00620005, ContentRule::SegmentLabel}, ContentElement{0x00620008},
    ContentElement{0x00620009, ContentRule::Algorithm}, ContentElement{0x0062000a}, ContentElement{0x0062000b},
    ContentElement{0x0062000d}, ContentElement{0x0062000e}, ContentElement{0x0062000f}, ContentElement{0x00620010},
    ContentElement{0x00620011}, ContentElement{0x00620013}, ContentElement{0x00620021},
    // Graphics, displayed area and layers (C.10.4 to C.10.7), registration (C.20.2).
    ContentElement{0x00700001}, ContentElement{0x00700002, ContentRule::Layer}, ContentElement{0x00700003},
    ContentElement{0x00700004}, ContentElement{0x00700005}, ContentElement{0x00700006, ContentRule::Words},
    ContentElement{0x00700008}, ContentElement{0x00700009}, ContentElement{0x00700010}, ContentElement{0x00700011},
    ContentElement{0x00700012}, ContentElement{0x00700014}, ContentElement{0x00700015}, ContentElement{0x00700020},
    ContentElement{0x00700021}, ContentElement{0x00700022}, ContentElement{0x00700023}, ContentElement{0x00700024},
    ContentElement{0x00700041}, ContentElement{0x00700042}, ContentElement{0x00700052}, ContentElement{0x00700053},
    ContentElement{0x0070005a}, ContentElement{0x00700060}, ContentElement{0x00700062}, ContentElement{0x00700066},
    ContentElement{0x00700080, ContentRule::Label}, ContentElement{0x00700081, ContentRule::Empty},
    ContentElement{0x00700082, ContentRule::Time}, ContentElement{0x00700083, ContentRule::Time},
    ContentElement{0x00700084, ContentRule::Empty}, ContentElement{0x00700100}, ContentElement{0x00700101},
    ContentElement{0x00700102}, ContentElement{0x00700103}, ContentElement{0x00700308}, ContentElement{0x00700309},
    ContentElement{0x0070030a}, ContentElement{0x0070030c}, ContentElement{0x0070030d}, ContentElement{0x00700401},
    ContentElement{0x300600c6},
    // Reports (C.17.2, C.17.3, C.18).
    ContentElement{0x00080105, ContentRule::Template}, ContentElement{0x004008ea}, ContentElement{0x0040a010},
    ContentElement{0x0040a040}, ContentElement{0x0040a043}, ContentElement{0x0040a050}, ContentElement{0x0040a0b0},
    ContentElement{0x0040a120, ContentRule::Time}, ContentElement{0x0040a121, ContentRule::Time},
    ContentElement{0x0040a122, ContentRule::Time}, ContentElement{0x0040a123, ContentRule::Name},
    ContentElement{0x0040a124}, ContentElement{0x0040a130}, ContentElement{0x0040a132}, ContentElement{0x0040a138},
    ContentElement{0x0040a160, ContentRule::Words}, ContentElement{0x0040a161}, ContentElement{0x0040a162},
    ContentElement{0x0040a163}, ContentElement{0x0040a168}, ContentElement{0x0040a300}, ContentElement{0x0040a301},
    ContentElement{0x0040a30a}, ContentElement{0x0040a375}, ContentElement{0x0040a491},
    ContentElement{0x0040a493, ContentRule::Unverified}, ContentElement{0x0040a496}, ContentElement{0x0040a504},
    ContentElement{0x0040a730}, ContentElement{0x0040db00, ContentRule::Template}, ContentElement{0x0040db73},
    ContentElement{0x30060024}};

/// Labels that AngioPose writes to free-text elements.
constexpr std::array<std::string_view, 2> ownLabels{"ANGIOPOSE", "VESSELS"};
constexpr std::array<std::string_view, 4> ownWords{"AngioPose", "Arteries", "trustworthy", "not trustworthy"};
constexpr std::string_view programWord = "AngioPose ";

const ContentElement* contentElement(DicomTag tag)
{
    const auto found = std::ranges::find(contentElements, tag, &ContentElement::tag);
    return found == contentElements.end() ? nullptr : &*found;
}

template <std::size_t Count>
bool isAmong(const std::array<std::string_view, Count>& known, std::string_view value)
{
    return std::ranges::find(known, value) != known.end();
}

/// Returns whether `text` is AngioPose's name with a version, for example "AngioPose 1.2.0".
bool isProgramWithVersion(std::string_view text)
{
    return text.starts_with(programWord) && text.size() <= programWord.size() + 12 &&
           text.find_first_not_of("0123456789.", programWord.size()) == std::string_view::npos;
}

/// Returns whether `text` is a template identifier or mapping resource, for example "1500" or "DCMR".
bool isTemplate(std::string_view text)
{
    return text == "DCMR" ||
           (!text.empty() && text.size() <= 5 && text.find_first_not_of("0123456789") == std::string_view::npos);
}

}   // namespace

DeidentifiedTerm deidentifyTerm(const CodedEntry& term, const IdentityWords& words)
{
    if (const CodedTerm* known = knownTerm(term)) {
        return {{known->value, known->scheme, known->meaning}};
    }
    const auto scheme = std::ranges::find(publicSchemes, term.scheme, &PublicScheme::name);
    if (scheme == publicSchemes.end() || !scheme->isValue(term.value) || words.occurIn(term.value)) {
        return {{takenOut.value, takenOut.scheme, takenOut.meaning}, true};
    }
    return {{term.value, term.scheme, term.scheme + " " + term.value}};
}

bool ContentCleaner::has(DicomTag tag)
{
    return contentElement(tag) != nullptr;
}

bool ContentCleaner::isReplaced(DicomTag tag)
{
    const ContentElement* element = contentElement(tag);
    return element != nullptr && element->rule != ContentRule::AsUsual && element->rule != ContentRule::Time;
}

std::string ContentCleaner::replacementFor(DicomTag tag, const std::vector<std::string>& values)
{
    const std::string text = values.empty() ? std::string() : values.front();
    using enum ContentRule;
    switch (contentElement(tag)->rule) {
        case Label:
            return isAmong(ownLabels, text) ? text : "OBJECT";
        case Layer:
            return cleanLayer(text);
        case SegmentLabel:
            return cleanSegmentLabel(text);
        case Algorithm:
            return isProgramWithVersion(text) ? text : "unknown";
        case Words:
            return words(text);
        case Name:
            ++removedCount_;
            return "Removed";
        case Unverified:   // because the name of the verifying observer is removed
            return "UNVERIFIED";
        case Template:
            return isTemplate(text) ? text : "0";
        case AsUsual:
        case Empty:
        case Time:
            break;
    }
    return {};
}

std::optional<std::string> ContentCleaner::replacementForTime(DicomTag tag, const std::string& vr)
{
    const ContentElement* element = contentElement(tag);
    if (element == nullptr || element->rule != ContentRule::Time) {
        return std::nullopt;
    }
    return vr == "DA" ? "19000101" : vr == "TM" ? "000000" : "19000101000000";
}

CodedEntry ContentCleaner::term(const CodedEntry& term)
{
    DeidentifiedTerm kept = deidentifyTerm(term, words_);
    removedCount_ += kept.isReplaced ? 1 : 0;
    return std::move(kept.term);
}

std::string ContentCleaner::cleanLayer(const std::string& name)
{
    return layers_.try_emplace(name, "LAYER" + std::to_string(layers_.size() + 1)).first->second;
}

std::string ContentCleaner::cleanSegmentLabel(const std::string& label)
{
    ++segments_;
    if (isAmong(ownWords, label)) {
        return label;
    }
    ++removedCount_;
    return "Segment " + std::to_string(segments_);
}

std::string ContentCleaner::words(const std::string& text)
{
    if (isAmong(ownWords, text) || isProgramWithVersion(text)) {
        return text;
    }
    ++removedCount_;
    return "taken out (" + std::to_string(removedCount_) + ")";
}

}   // namespace angiopose::io
