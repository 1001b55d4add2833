#include "io/vessel/markups.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/json_text.h"
#include "io/support/numbers.h"
#include "io/vessel/fiducial_table.h"
#include "io/vessel/stated_coordinates.h"

#include <nlohmann/json.hpp>
#include <optional>

namespace angiopose::io {
namespace {

using Json = nlohmann::ordered_json;

/// Returns the conversion of the control points of a Slicer markup to LPS mm. Accepts the unit as a word or as [code,
/// scheme, meaning], and the axes in upper or lower case. The error for an unsupported unit or axes names the value.
core::Result<CoordinateConversion> ruleOf(const Json& markup, const std::string& path)
{
    const std::string system = markup.value("coordinateSystem", "LPS");
    const std::string axes = toLower(system);
    if (axes != "lps" && axes != "ras") {
        return fileError(path, messages::fiducialsSystem(system.substr(0, 20)));
    }
    const auto stated = markup.find("coordinateUnits");
    const std::string unit = stated == markup.end()                   ? "mm"
                             : stated->is_array() && !stated->empty() ? stated->front().get<std::string>()
                                                                      : stated->get<std::string>();
    const auto unitMm = lengthUnitMm(unit);
    if (!unitMm) {
        return fileError(path, messages::markupsUnit(unit.substr(0, 20)));
    }
    CoordinateConversion rule;
    rule.unitMm = *unitMm;
    rule.isRas = axes == "ras";
    return rule;
}

/// Returns the point; nullopt if it is not placed. Throws if the JSON does not describe a point.
std::optional<Eigen::Vector3d> placedPoint(const Json& control, const CoordinateConversion& rule)
{
    const auto position = control.find("position");
    if (toLower(control.value("positionStatus", "defined")) != "defined" || position == control.end() ||
        position->is_null()) {
        return std::nullopt;
    }
    const auto numbers = position->get<std::vector<double>>();
    return rule({numbers.at(0), numbers.at(1), numbers.at(2)});
}

/// Returns a Slicer file with these markups as text.
std::string markupsFile(Json markups)
{
    Json root;
    root["@schema"] =
        "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/"
        "markups-schema-v1.0.3.json#";
    root["markups"] = std::move(markups);
    return prettyJson(root.dump(-1, ' ', false, Json::error_handler_t::replace));
}

bool isCurve(const Json& markup)
{
    const std::string type = markup.value("type", "");
    return type == "Curve" || type == "ClosedCurve" || type == "Line";
}

/// Appends a curve; returns the number of its points that are not placed.
std::size_t appendCurve(const Json& markup, const CoordinateConversion& rule, LineSet& set)
{
    std::vector<std::size_t> line;
    std::size_t notPlaced = 0;
    for (const Json& control : markup.at("controlPoints")) {
        if (const auto point = placedPoint(control, rule)) {
            line.push_back(set.points.size());
            set.points.push_back(*point);
        } else {
            ++notPlaced;
        }
    }
    set.lines.push_back(std::move(line));
    set.names.push_back(markup.value("name", ""));
    return notPlaced;
}

void appendFiducials(const Json& markup, const CoordinateConversion& rule, std::vector<Fiducial>& fiducials)
{
    for (const Json& control : markup.at("controlPoints")) {
        if (const auto point = placedPoint(control, rule)) {
            fiducials.push_back({*point, control.value("label", ""), control.value("description", "")});
        }
    }
}

}   // namespace

core::Result<LineSet> parseMarkups(std::string_view json, const std::string& path)
{
    if (const auto valid = checkJson(json, path); !valid) {
        return valid.error();
    }
    try {
        const Json root = Json::parse(json);
        LineSet set;
        std::size_t notPlaced = 0;
        for (const Json& markup : root.at("markups")) {
            if (isCurve(markup)) {
                const auto rule = ruleOf(markup, path);
                if (!rule) {
                    return rule.error();
                }
                notPlaced += appendCurve(markup, rule.value(), set);
            }
        }
        if (notPlaced > 0) {
            set.warnings.push_back(messages::markupsNotPlaced(notPlaced));
        }
        return set;
    } catch (const std::exception&) {   // a key is missing, a type is wrong, or there are too few coordinates
        return fileError(path, messages::markupsNone());
    }
}

std::string markupsText(const core::VesselTree& tree)
{
    Json markups = Json::array();
    for (const core::VesselBranch& branch : tree.branches) {
        Json curve;
        curve["type"] = "Curve";
        curve["coordinateSystem"] = "LPS";
        curve["coordinateUnits"] = "mm";
        curve["name"] = branch.name.empty() ? "Branch " + std::to_string(branch.id) : branch.name;
        curve["controlPoints"] = Json::array();
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            const Eigen::Vector3d& point = branch.pointsInPatient[i];
            curve["controlPoints"].push_back({{"id", std::to_string(i + 1)},
                                              {"position", {point.x(), point.y(), point.z()}},
                                              {"positionStatus", "defined"}});
        }
        markups.push_back(std::move(curve));
    }
    return markupsFile(std::move(markups));
}

core::Result<std::vector<Fiducial>> parseFiducialMarkups(std::string_view json, const std::string& path)
{
    if (const auto valid = checkJson(json, path); !valid) {
        return valid.error();
    }
    std::vector<Fiducial> fiducials;
    try {
        const Json root = Json::parse(json);
        for (const Json& markup : root.at("markups")) {
            if (markup.value("type", "") != "Fiducial") {
                continue;
            }
            const auto rule = ruleOf(markup, path);
            if (!rule) {
                return rule.error();
            }
            appendFiducials(markup, rule.value(), fiducials);
        }
    } catch (const std::exception&) {   // a key is missing, a type is wrong, or there are too few coordinates
        fiducials.clear();
    }
    return fiducials.empty() ? core::Result<std::vector<Fiducial>>(fileError(path, messages::fiducialsNone()))
                             : fiducials;
}

std::string fiducialMarkups(const std::vector<Fiducial>& fiducials)
{
    Json markup{{"type", "Fiducial"}, {"coordinateSystem", "LPS"}, {"coordinateUnits", "mm"}};
    markup["controlPoints"] = Json::array();
    for (std::size_t i = 0; i < fiducials.size(); ++i) {
        const Eigen::Vector3d& point = fiducials[i].pointInPatient;
        markup["controlPoints"].push_back({{"id", std::to_string(i + 1)},
                                           {"label", fiducials[i].name},
                                           {"description", fiducials[i].description},
                                           {"position", {point.x(), point.y(), point.z()}},
                                           {"positionStatus", "defined"}});
    }
    return markupsFile(Json::array({std::move(markup)}));
}

}   // namespace angiopose::io
