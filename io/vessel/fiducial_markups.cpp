#include "io/messages/says_exchange.h"
#include "io/support/file_error.h"
#include "io/support/json_text.h"
#include "io/vessel/fiducial_table.h"
#include "io/vessel/markup_points.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using MarkupJson = nlohmann::ordered_json;

void appendFiducials(const MarkupJson& markup, const CoordinateRule& rule, std::vector<Fiducial>& fiducials)
{
    for (const MarkupJson& control : markup.at("controlPoints")) {
        if (const auto point = placedPoint(control, rule)) {
            fiducials.push_back({*point, control.value("label", ""), control.value("description", "")});
        }
    }
}

}   // namespace

core::Result<std::vector<Fiducial>> parseFiducialMarkups(std::string_view json, const std::string& path)
{
    if (const auto valid = checkJson(json, path); !valid) {
        return valid.error();
    }
    std::vector<Fiducial> fiducials;
    try {
        const MarkupJson root = MarkupJson::parse(json);
        for (const MarkupJson& markup : root.at("markups")) {
            if (markup.value("type", "") != "Fiducial") {
                continue;
            }
            const auto rule = ruleOf(markup, path);
            if (!rule) {
                return rule.error();
            }
            appendFiducials(markup, rule.value(), fiducials);
        }
    } catch (const std::exception&) {   // missing keys, wrong kinds, too few coordinates
        fiducials.clear();
    }
    return fiducials.empty() ? core::Result<std::vector<Fiducial>>(fileError(path, says::fiducialsNone())) : fiducials;
}

std::string fiducialMarkups(const std::vector<Fiducial>& fiducials)
{
    MarkupJson markup{{"type", "Fiducial"}, {"coordinateSystem", "LPS"}, {"coordinateUnits", "mm"}};
    markup["controlPoints"] = MarkupJson::array();
    for (std::size_t i = 0; i < fiducials.size(); ++i) {
        const Eigen::Vector3d& point = fiducials[i].pointInPatient;
        markup["controlPoints"].push_back({{"id", std::to_string(i + 1)},
                                           {"label", fiducials[i].name},
                                           {"description", fiducials[i].description},
                                           {"position", {point.x(), point.y(), point.z()}},
                                           {"positionStatus", "defined"}});
    }
    return markupsFile(MarkupJson::array({std::move(markup)}));
}

}   // namespace angiopose::io
