#include "io/vessel/markups.h"

#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/json_text.h"
#include "io/vessel/markup_points.h"

#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using Json = nlohmann::ordered_json;

bool isCurve(const Json& markup)
{
    const std::string type = markup.value("type", "");
    return type == "Curve" || type == "ClosedCurve" || type == "Line";
}

/// Returns how many of its points are not placed.
std::size_t appendCurve(const Json& markup, const CoordinateRule& rule, LineSet& set)
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
            set.warnings.push_back(says::markupsNotPlaced(notPlaced));
        }
        return set;
    } catch (const std::exception&) {   // missing keys, wrong kinds, too few coordinates
        return fileError(path, says::markupsNone());
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

}   // namespace angiopose::io