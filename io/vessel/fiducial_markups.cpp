#include "io/messages/says_exchange.h"
#include "io/support/file_error.h"
#include "io/support/json_text.h"
#include "io/vessel/fiducial_table.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using MarkupJson = nlohmann::ordered_json;

void appendFiducials(const MarkupJson& markup, bool isRas, std::vector<Fiducial>& fiducials)
{
    for (const MarkupJson& control : markup.at("controlPoints")) {
        if (control.value("positionStatus", "defined") != "defined") {
            continue;
        }
        const auto position = control.at("position").get<std::vector<double>>();
        Fiducial fiducial{{position.at(0), position.at(1), position.at(2)},
                          control.value("label", ""),
                          control.value("description", "")};
        if (isRas) {
            fiducial.pointInPatient.head<2>() *= -1.0;
        }
        fiducials.push_back(std::move(fiducial));
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
            const std::string system = markup.value("coordinateSystem", "LPS");
            if ((system != "LPS" && system != "RAS") || markup.value("coordinateUnits", "mm") != "mm") {
                return fileError(path, says::fiducialsSystem(system.substr(0, 20)));
            }
            appendFiducials(markup, system == "RAS", fiducials);
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
    MarkupJson root;
    root["@schema"] =
        "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/"
        "markups-schema-v1.0.3.json#";
    root["markups"] = MarkupJson::array({std::move(markup)});
    return prettyJson(root.dump(-1, ' ', false, MarkupJson::error_handler_t::replace));
}

}   // namespace angiopose::io
