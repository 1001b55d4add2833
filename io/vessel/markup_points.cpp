#include "io/vessel/markup_points.h"

#include "io/messages/says.h"
#include "io/messages/says_exchange.h"
#include "io/support/file_error.h"
#include "io/support/json_text.h"
#include "io/support/numbers.h"

#include <vector>

namespace angiopose::io {

core::Result<CoordinateRule> ruleOf(const nlohmann::ordered_json& markup, const std::string& path)
{
    const std::string system = markup.value("coordinateSystem", "LPS");
    const std::string axes = lowered(system);
    if (axes != "lps" && axes != "ras") {
        return fileError(path, says::fiducialsSystem(system.substr(0, 20)));
    }
    const auto stated = markup.find("coordinateUnits");
    const std::string unit = stated == markup.end()                   ? "mm"
                             : stated->is_array() && !stated->empty() ? stated->front().get<std::string>()
                                                                      : stated->get<std::string>();
    const auto unitMm = lengthUnitMm(unit);
    if (!unitMm) {
        return fileError(path, says::markupsUnit(unit.substr(0, 20)));
    }
    CoordinateRule rule;
    rule.unitMm = *unitMm;
    rule.isRas = axes == "ras";
    return rule;
}

std::optional<Eigen::Vector3d> placedPoint(const nlohmann::ordered_json& control, const CoordinateRule& rule)
{
    const auto position = control.find("position");
    if (lowered(control.value("positionStatus", "defined")) != "defined" || position == control.end() ||
        position->is_null()) {
        return std::nullopt;
    }
    const auto numbers = position->get<std::vector<double>>();
    return rule({numbers.at(0), numbers.at(1), numbers.at(2)});
}

std::string markupsFile(nlohmann::ordered_json markups)
{
    nlohmann::ordered_json root;
    root["@schema"] =
        "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/"
        "markups-schema-v1.0.3.json#";
    root["markups"] = std::move(markups);
    return prettyJson(root.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

}   // namespace angiopose::io
