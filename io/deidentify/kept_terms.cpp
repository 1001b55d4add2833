#include "io/deidentify/kept_terms.h"

#include "io/dicom/objects/coded_term.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string_view>

namespace angiopose::io {
namespace {

constexpr CodedTerm takenOut{"AP0", "99ANGIOPOSE", "Term that was taken out"};

/// What this program's own objects say; a test compares.
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

/// Units in braces could be any words, and a name of letters could pass for a unit: only these.
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

/// "T-D0050", "R-10241".
bool isSnomedThree(std::string_view value)
{
    const bool isHex = std::ranges::all_of(value.substr(std::min<std::size_t>(value.size(), 2)),
                                           [](char c) { return isCodeDigit(c) || (c >= 'A' && c <= 'F'); });
    return value.size() >= 6 && value.size() <= 8 && value[0] >= 'A' && value[0] <= 'Z' && value[1] == '-' && isHex;
}

/// "18745-0".
bool isLoinc(std::string_view value)
{
    return value.size() >= 4 && value.size() <= 8 && value[value.size() - 2] == '-' && isCodeDigit(value.back()) &&
           isNumberOf(value.substr(0, value.size() - 2), 2, 6);
}

/// "en", "en-US".
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

/// Schemes that anybody can look up, and what their values look like.
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

const CodedTerm* knownTerm(const ReadTerm& term)
{
    const auto found = std::ranges::find_if(
        knownTerms, [&](const CodedTerm& known) { return term.value == known.value && term.scheme == known.scheme; });
    return found == knownTerms.end() ? nullptr : &*found;
}

}   // namespace

KeptTerm keptTerm(const ReadTerm& term, const IdentityWords& words)
{
    if (const CodedTerm* known = knownTerm(term)) {
        return {{known->value, known->scheme, known->meaning}};
    }
    const auto scheme = std::ranges::find(publicSchemes, term.scheme, &PublicScheme::name);
    if (scheme == publicSchemes.end() || !scheme->isValue(term.value) || words.areIn(term.value)) {
        return {{takenOut.value, takenOut.scheme, takenOut.meaning}, true};
    }
    return {{term.value, term.scheme, term.scheme + " " + term.value}};
}

}   // namespace angiopose::io
