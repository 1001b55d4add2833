#include "io/vessel/stated_coordinates.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/support/text_cursor.h"
#include "io/vessel/surface_formats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <regex>

namespace angiopose::io {
namespace {

constexpr std::size_t headBytes = 8192;
constexpr std::size_t longestLine = 200;   // longer lines are not prose and recurse deeply in std::regex

struct StatedUnit {
    double unitMm = 1.0;
    std::string words;
};

const std::string number = R"((\d+(?:\.\d*)?(?:e[-+]?\d+)?|\.\d+))";
const std::string unitName =
    "(mm|cm|dm|m|um|\xc2\xb5m|\xce\xbcm|(?:milli|centi|deci|micro)?[ -]?met(?:er|re)s?|microns?|inch(?:es)?)";

double valueOf(const std::ssub_match& found, double otherwise)
{
    return found.matched ? parseNumber(found.str()).value_or(0.0) : otherwise;
}

double mmOf(const std::ssub_match& found)
{
    return lengthUnitMm(found.str()).value_or(0.0);
}

/// Recognizes "1 unit = 10 mm", "Units: inches", "UNITS=mm", "1000 units are 1 m".
std::optional<StatedUnit> unitNamed(const std::string& line)
{
    static const std::regex form("(?:" + number +
                                     R"(\s*)?units?\b["']?\s*(?:(?:=|:|is|are|in|equals?|as)\s*)*["']?(?:)" + number +
                                     R"(\s*)?(?:)" + unitName + R"(|(in|ft|feet|foot))(?![\w/]))",
                                 std::regex::icase);
    std::smatch found;
    if (!std::regex_search(line, found, form)) {
        return std::nullopt;
    }
    const double unitMm = mmOf(found[found[3].matched ? 3 : 4]);
    return StatedUnit{valueOf(found[2], 1.0) * unitMm / valueOf(found[1], 1.0), found.str()};
}

/// Recognizes "10 mm per unit", "unitMm = 10".
std::optional<StatedUnit> unitCounted(const std::string& line)
{
    static const std::regex form(number + R"(\s*)" + unitName +
                                     R"(\s*(?:per|/|=|is)\s*(?:1\s*|one\s*|an?\s*)?unit\b|)" +
                                     R"(units?_?(?:in_?)?(mm|cm|um|m)\b\s*[=:]?\s*)" + number,
                                 std::regex::icase);
    std::smatch found;
    if (!std::regex_search(line, found, form)) {
        return std::nullopt;
    }
    return found[1].matched ? StatedUnit{valueOf(found[1], 1.0) * mmOf(found[2]), found.str()}
                            : StatedUnit{valueOf(found[4], 1.0) * mmOf(found[3]), found.str()};
}

/// Recognizes "all coordinates are in cm", "points (mm)".
std::optional<StatedUnit> unitOfLengths(const std::string& line)
{
    static const std::regex form(
        "\\b(?:coordinates?|vertices|points?|dimensions?|lengths?|measured|positions?|"
        "distances?|expressed|exported|scale|mesh|geometry)\\b[^.;]{0,40}?(?:\\bin\\s+|[(\\[]"
        "\\s*)" +
            unitName + R"((?:\s*[)\]]|(?![\w/])))",
        std::regex::icase);
    std::smatch found;
    return std::regex_search(line, found, form) ? std::optional(StatedUnit{mmOf(found[1]), found.str()}) : std::nullopt;
}

std::optional<StatedUnit> unitIn(const std::string& line)
{
    for (const auto& find : {unitNamed, unitCounted, unitOfLengths}) {
        const auto unit = find(line);
        if (unit && unit->unitMm >= 1e-6 && unit->unitMm <= 1e4) {
            return unit;
        }
    }
    return std::nullopt;
}

/// Returns the axis directions in capital letters, as in "SPACE=RAS" or "coordinate system: LPS".
std::string axesIn(const std::string& line)
{
    static const std::regex form(
        R"((?:space|coordinate[ _]?system|coordinates|axes|orientation)["']?\s*(?:=|:|is|are|in)\s*["']?([RLAPSI]{3})\b|)"
        R"((right[- ]anterior[- ]superior)|(left[- ]posterior[- ]superior))",
        std::regex::icase);
    std::smatch found;
    if (!std::regex_search(line, found, form)) {
        return {};
    }
    std::string axes = found[2].matched ? "RAS" : found[3].matched ? "LPS" : found[1].str();
    const std::string name = toLower(axes);
    if (name == "ras" || name == "lps" || found.str().find_first_of("=:") != std::string::npos) {
        std::ranges::transform(axes, axes.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    }
    const bool isWhole = std::ranges::all_of(std::array{"RL", "AP", "SI"}, [&axes](const char* pair) {
        return axes.find_first_of(pair) != std::string::npos;
    });
    return isWhole ? axes : std::string();
}

}   // namespace

std::optional<double> lengthUnitMm(std::string_view word)
{
    static const std::map<std::string, double, std::less<>> units = {
        {"mm", 1.0},          {"cm", 10.0},        {"dm", 100.0},       {"m", 1000.0},        {"um", 1e-3},
        {"\xc2\xb5m", 1e-3},  {"\xce\xbcm", 1e-3}, {"nm", 1e-6},        {"in", 25.4},         {"inch", 25.4},
        {"inches", 25.4},     {"[in_i]", 25.4},    {"ft", 304.8},       {"foot", 304.8},      {"feet", 304.8},
        {"micron", 1e-3},     {"meter", 1000.0},   {"millimeter", 1.0}, {"centimeter", 10.0}, {"decimeter", 100.0},
        {"micrometer", 1e-3}, {"nanometer", 1e-6}};
    std::string name = toLower(trimmed(word));
    std::erase_if(name, [](char c) { return c == ' ' || c == '-'; });
    if (const std::size_t meter = name.find("metre"); meter != std::string::npos) {
        name.replace(meter, 5, "meter");
    }
    if (name.ends_with("meters") || name.ends_with("microns")) {
        name.pop_back();
    }
    const auto found = units.find(name);
    return found == units.end() ? std::nullopt : std::optional(found->second);
}

std::string headerText(std::string_view content)
{
    if (looksLikeBinaryStl(content)) {
        return std::string(content.substr(0, 80));
    }
    std::string text;
    TextReader lines(content.substr(0, headBytes));
    for (int number = 1; lines.left() > 0; ++number) {
        const std::string_view line = lines.line();
        const std::string start = toLower(line.substr(0, 8));
        const bool isTitle = number == 2 && content.starts_with("# vtk");
        if (isTitle || start.starts_with('#') || start.starts_with("comment") || start.starts_with("obj_info") ||
            start.starts_with("solid") || line.find("<!--") != std::string_view::npos) {
            text += std::string(line) + "\n";
        }
    }
    return text;
}

core::Result<CoordinateConversion> coordinateConversion(std::string_view header, double requestedUnitMm,
                                                        const std::string& path)
{
    if (!std::isfinite(requestedUnitMm) || requestedUnitMm < 0.0) {
        return fileError(path, messages::fileWrongUnit());
    }
    CoordinateConversion rule;
    std::optional<StatedUnit> stated;
    std::string axes;
    for (TextReader lines(header); lines.left() > 0;) {
        const std::string line(lines.line().substr(0, longestLine));
        const auto unit = unitIn(line);
        if (unit && stated && unit->unitMm != stated->unitMm) {
            rule.notes.push_back(messages::unitsContradict(stated->words, unit->words));
        }
        stated = stated ? stated : unit;
        axes = axes.empty() ? axesIn(line) : axes;
    }
    if (!axes.empty() && axes != "RAS" && axes != "LPS") {
        return fileError(path, messages::axesOther(axes));
    }
    rule.isRas = axes == "RAS";
    rule.isUnitStated = stated.has_value();
    rule.unitMm = requestedUnitMm > 0.0 ? requestedUnitMm : stated ? stated->unitMm : 1.0;
    if (stated && (stated->unitMm != 1.0 || rule.unitMm != 1.0)) {
        const auto inMm = [](double mm) { return core::Quantity{mm, core::Quantity::significantDigits, "mm"}; };
        const bool isOverruled = std::abs(rule.unitMm - stated->unitMm) > 1e-9 * rule.unitMm;
        rule.notes.push_back(isOverruled
                                 ? messages::unitOverruled(stated->words, inMm(stated->unitMm), inMm(rule.unitMm))
                                 : messages::unitStated(stated->words, inMm(stated->unitMm)));
    }
    return rule;
}

}   // namespace angiopose::io
