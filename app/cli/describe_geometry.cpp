#include "app/cli/describe_geometry.h"

#include "app/texts/case_texts.h"
#include "core/geometry/geometry_checks.h"
#include "io/support/message_json.h"

#include <string>
#include <vector>

namespace angiopose::app {
namespace {

using Json = nlohmann::ordered_json;

Json sourcedJson(const core::Sourced<double>& sourced)
{
    Json json{{"value", nullptr}, {"origin", originText(sourced.origin)}};
    if (sourced.value) {
        json["value"] = *sourced.value;
    }
    if (!sourced.basis.empty()) {
        json["basis"] = sourced.basis;
    }
    return json;
}

template <class Vector>
Json sourcedJson(const core::Sourced<Vector>& sourced)
{
    Json json{{"value", nullptr}, {"origin", originText(sourced.origin)}};
    if (sourced.value) {
        json["value"] = std::vector<double>(sourced.value->begin(), sourced.value->end());
        json["basis"] = sourced.basis;
    }
    return json;
}

/// Describes the viewing side of the image (FORMATS §1), i.e. the sign of fx.
std::string shownFrom(const core::CArm& cArm)
{
    const std::string basis = cArm.mirrored.value ? originText(cArm.mirrored.origin) + ", " + cArm.mirrored.basis
                                                  : "assumed, not in the header";
    return (cArm.mirrored.value.value_or(false) ? "mirrored, as seen from the source, fx > 0 ("
                                                : "as seen from the detector, fx < 0 (") +
           basis + ")";
}

}   // namespace

nlohmann::ordered_json cameraJson(const core::ProjectionCamera& camera)
{
    return {{"fx", camera.fx}, {"fy", camera.fy}, {"cx", camera.cx}, {"cy", camera.cy}};
}

nlohmann::ordered_json geometryJson(const core::CArm& cArm, const core::Angiogram& angiogram)
{
    Json json{
        {"sourceToDetectorMm", sourcedJson(cArm.sourceToDetectorMm)},
        {"sourceToIsocenterMm", sourcedJson(cArm.sourceToIsocenterMm)},
        {"sourceToObjectMm", sourcedJson(cArm.sourceToObjectMm)},
        {"columnSpacingMm", sourcedJson(cArm.columnSpacingMm)},
        {"rowSpacingMm", sourcedJson(cArm.rowSpacingMm)},
        {"primaryAngleDeg", sourcedJson(cArm.primaryAngleDeg)},
        {"secondaryAngleDeg", sourcedJson(cArm.secondaryAngleDeg)},
        {"rollDeg", sourcedJson(cArm.rollDeg)},
        {"principalPointPx", sourcedJson(cArm.principalPointPx)},
        {"isocentreInPatientMm", sourcedJson(cArm.isocenterInPatientMm)},
        {"mirrored", cArm.mirrored.value.value_or(false)},
        {"shown", shownFrom(cArm)},
    };
    if (const auto& depth = vesselDepthOf(cArm).value; cArm.sourceToDetectorMm.value && depth) {
        json["magnification"] = *cArm.sourceToDetectorMm.value / *depth;
    }
    const auto camera = core::cameraFromCArm(cArm, angiogram.width(), angiogram.height());
    if (camera) {
        json["camera"] = cameraJson(camera.value());
    } else {
        json["cameraMissing"] = camera.error().message.text();
    }
    const core::Messages contradictions =
        core::findContradictions(cArm, angiogram.gantry, {angiogram.width(), angiogram.height()});
    const core::Messages missing = core::findMissing(cArm);
    json["contradictions"] = io::sentencesOf(contradictions);
    json["missing"] = io::sentencesOf(missing);
    json["messages"] = Json::array();
    for (const core::Messages& each : {contradictions, missing}) {
        for (const core::Message& message : each) {
            json["messages"].push_back(Json::parse(io::messageJson(message)));
        }
    }
    if (const auto& table = angiogram.gantry.table) {
        const Eigen::Vector3d& isocenter = table->isocenterInPatientMm;
        json["isocenterByTableMm"] = {isocenter.x(), isocenter.y(), isocenter.z()};
    }
    json["tableMovesDuringRun"] = angiogram.gantry.tableMoves;
    json["turnsDuringRun"] = !angiogram.gantry.angleIncrementsDeg.empty();
    Json& header = json["header"] = Json::object();
    for (const core::HeaderTag& tag : angiogram.gantry.tags) {
        header[tag.tag + " " + tag.name] = tag.value;
    }
    return json;
}

}   // namespace angiopose::app
