#include "io/vessel/markups.h"

#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/json_text.h"

#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using Json = nlohmann::ordered_json;

bool isCurve(const Json& markup)
{
    const std::string type = markup.value("type", "");
    return type == "Curve" || type == "ClosedCurve" || type == "Line";
}

void appendCurve(const Json& markup, LineSet& set)
{
    const bool isRas = markup.value("coordinateSystem", "LPS") == "RAS";
    std::vector<std::size_t> line;
    for (const Json& control : markup.at("controlPoints")) {
        if (control.value("positionStatus", "defined") != "defined") {
            continue;
        }
        const auto position = control.at("position").get<std::vector<double>>();
        Eigen::Vector3d point(position.at(0), position.at(1), position.at(2));
        if (isRas) {
            point.head<2>() = -point.head<2>();
        }
        line.push_back(set.points.size());
        set.points.push_back(point);
    }
    set.lines.push_back(std::move(line));
    set.names.push_back(markup.value("name", ""));
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
        for (const Json& markup : root.at("markups")) {
            const std::string unit = markup.value("coordinateUnits", "mm");
            if (isCurve(markup) && unit != "mm") {
                return fileError(path, says::markupsUnit(unit.substr(0, 20)));
            }
            if (isCurve(markup)) {
                appendCurve(markup, set);
            }
        }
        return set;
    } catch (const std::exception&) {   // missing keys, wrong kinds, too few coordinates
        return fileError(path, says::markupsNone());
    }
}

std::string markupsText(const core::VesselTree& tree)
{
    Json root;
    root["@schema"] =
        "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/"
        "markups-schema-v1.0.3.json#";
    root["markups"] = Json::array();
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
        root["markups"].push_back(std::move(curve));
    }
    return prettyJson(root.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}   // namespace angiopose::io