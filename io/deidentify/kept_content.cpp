#include "io/deidentify/kept_content.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace angiopose::io {
namespace {

enum class ContentRule {
    AsUsual,   ///< sequences, numbers, codes, UIDs
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
    // When it was made; references.
    ContentElement{0x00080023, ContentRule::Time}, ContentElement{0x00080033, ContentRule::Time},
    ContentElement{0x00081115}, ContentElement{0x0008114a}, ContentElement{0x00081160}, ContentElement{0x00081199},
    ContentElement{0x00089124}, ContentElement{0x00089215}, ContentElement{0x0040a170},
    // Segments (PS3.3 C.8.20.2).
    ContentElement{0x00620001}, ContentElement{0x00620002}, ContentElement{0x00620003}, ContentElement{0x00620004},
    ContentElement{0x00620005, ContentRule::SegmentLabel}, ContentElement{0x00620008},
    ContentElement{0x00620009, ContentRule::Algorithm}, ContentElement{0x0062000a}, ContentElement{0x0062000b},
    ContentElement{0x0062000d}, ContentElement{0x0062000e}, ContentElement{0x0062000f}, ContentElement{0x00620010},
    ContentElement{0x00620011}, ContentElement{0x00620013}, ContentElement{0x00620021},
    // Graphics, displayed area, layers (C.10.4 to C.10.7), registration (C.20.2).
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

/// What this program itself writes where others write what they like.
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

/// "AngioPose 1.2.0".
bool isProgramWithVersion(std::string_view text)
{
    return text.starts_with(programWord) && text.size() <= programWord.size() + 12 &&
           text.find_first_not_of("0123456789.", programWord.size()) == std::string_view::npos;
}

/// "DCMR", "1500".
bool isTemplate(std::string_view text)
{
    return text == "DCMR" ||
           (!text.empty() && text.size() <= 5 && text.find_first_not_of("0123456789") == std::string_view::npos);
}

}   // namespace

bool KeptContent::has(DicomTag tag)
{
    return contentElement(tag) != nullptr;
}

bool KeptContent::isReplaced(DicomTag tag)
{
    const ContentElement* element = contentElement(tag);
    return element != nullptr && element->rule != ContentRule::AsUsual && element->rule != ContentRule::Time;
}

std::string KeptContent::insteadOf(DicomTag tag, const std::vector<std::string>& values)
{
    const std::string text = values.empty() ? std::string() : values.front();
    using enum ContentRule;
    switch (contentElement(tag)->rule) {
        case Label:
            return isAmong(ownLabels, text) ? text : "OBJECT";
        case Layer:
            return layer(text);
        case SegmentLabel:
            return segmentLabel(text);
        case Algorithm:
            return isProgramWithVersion(text) ? text : "not told";
        case Words:
            return words(text);
        case Name:
            ++cleared_;
            return "Removed";
        case Unverified:   // whoever verified it is not named any more
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

std::optional<std::string> KeptContent::insteadOfTime(DicomTag tag, const std::string& vr)
{
    const ContentElement* element = contentElement(tag);
    if (element == nullptr || element->rule != ContentRule::Time) {
        return std::nullopt;
    }
    return vr == "DA" ? "19000101" : vr == "TM" ? "000000" : "19000101000000";
}

ReadTerm KeptContent::term(const ReadTerm& term)
{
    KeptTerm kept = keptTerm(term, words_);
    cleared_ += kept.isReplaced ? 1 : 0;
    return std::move(kept.term);
}

std::string KeptContent::layer(const std::string& name)
{
    return layers_.try_emplace(name, "LAYER" + std::to_string(layers_.size() + 1)).first->second;
}

std::string KeptContent::segmentLabel(const std::string& label)
{
    ++segments_;
    if (isAmong(ownWords, label)) {
        return label;
    }
    ++cleared_;
    return "Segment " + std::to_string(segments_);
}

std::string KeptContent::words(const std::string& text)
{
    if (isAmong(ownWords, text) || isProgramWithVersion(text)) {
        return text;
    }
    ++cleared_;
    return "taken out (" + std::to_string(cleared_) + ")";
}

}   // namespace angiopose::io
