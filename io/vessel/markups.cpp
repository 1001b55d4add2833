#include "io/vessel/markups.h"

#include "io/support/file_error.h"
#include "io/support/json_text.h"

#include <nlohmann/json.hpp>

namespace io {
namespace {

using Json = nlohmann::json;

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
                return fileError(path, "its coordinates are in " + unit.substr(0, 20) + ". Export the curves in mm.");
            }
            if (isCurve(markup)) {
                appendCurve(markup, set);
            }
        }
        return set;
    } catch (const std::exception&) {   // missing keys, wrong kinds, too few coordinates
        return fileError(path,
                         "it is not a Slicer markups file with curves. Export the centrelines as .mrk.json curves, "
                         ".vtp, .vtk, .csv or .swc.");
    }
}

}   // namespace io
