#include "io/case/geometry_values.h"

#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using core::Origin;
using core::Sourced;
using Json = nlohmann::json;

Origin originFrom(const std::string& text)
{
    return text == "header"    ? Origin::Header
           : text == "derived" ? Origin::Derived
           : text == "assumed" ? Origin::Assumed
                               : Origin::User;
}

/// A bare value was typed by a user; an object says where its value comes from.
struct SourcedJson {
    Json value;
    Origin origin = Origin::Missing;
    std::string basis;
};

SourcedJson sourcedJson(const Json& json)
{
    if (json.is_null()) {
        return {};
    }
    if (!json.is_object()) {
        return {json, Origin::User, ""};
    }
    return {json.at("value"), originFrom(json.value("origin", "user")), json.value("basis", "")};
}

Sourced<double> sourcedNumber(const SourcedJson& json)
{
    return json.value.is_number() ? Sourced<double>{json.value.get<double>(), json.origin, json.basis}
                                  : Sourced<double>{};
}

void readCArm(const Json& geometry, core::CArm& cArm)
{
    cArm.sourceToDetectorMm = sourcedNumber(sourcedJson(geometry.value("sourceToDetectorMm", Json())));
    cArm.sourceToPatientMm = sourcedNumber(sourcedJson(geometry.value("sourceToPatientMm", Json())));
    cArm.primaryAngleDeg = sourcedNumber(sourcedJson(geometry.value("primaryAngleDeg", Json())));
    cArm.secondaryAngleDeg = sourcedNumber(sourcedJson(geometry.value("secondaryAngleDeg", Json())));
    cArm.rollDeg = sourcedNumber(sourcedJson(geometry.value("rollDeg", Json())));
    if (const SourcedJson spacing = sourcedJson(geometry.value("imagerPixelSpacingMm", Json()));
        spacing.value.is_array()) {
        cArm.rowSpacingMm = {spacing.value[0].get<double>(), spacing.origin, spacing.basis};
        cArm.columnSpacingMm = {spacing.value[1].get<double>(), spacing.origin, spacing.basis};
    }
    if (const SourcedJson point = sourcedJson(geometry.value("principalPointPx", Json())); point.value.is_array()) {
        cArm.principalPointPx = {Eigen::Vector2d(point.value[0].get<double>(), point.value[1].get<double>()),
                                 point.origin, point.basis};
    }
    if (const SourcedJson point = sourcedJson(geometry.value("isocentreInPatientMm", Json())); point.value.is_array()) {
        cArm.isocentreInPatientMm = {
            Eigen::Vector3d(point.value[0].get<double>(), point.value[1].get<double>(), point.value[2].get<double>()),
            point.origin, point.basis};
    }
    if (const SourcedJson mirrored = sourcedJson(geometry.value("mirrored", Json())); mirrored.value.is_boolean()) {
        cArm.mirrored = {mirrored.value.get<bool>(), mirrored.origin, mirrored.basis};
    }
}

void readCamera(const Json& camera, core::ViewGeometry& geometry, core::Messages& problems)
{
    if (!camera.is_object()) {
        return;
    }
    const core::ProjectionCamera given{camera["fx"].get<double>(), camera["fy"].get<double>(),
                                       camera["cx"].get<double>(), camera["cy"].get<double>(),
                                       camera["width"].get<int>(), camera["height"].get<int>()};
    if (const auto problem = core::findProblem(given)) {
        problems.push_back(problem->about("geometry.camera"));
    }
    geometry.cameraOverride = given;
}

}   // namespace

void readGeometry(const std::string& json, core::ViewGeometry& geometry, core::Messages& problems)
{
    const Json values = Json::parse(json);
    readCArm(values, geometry.cArm);
    readCamera(values.value("camera", Json()), geometry, problems);
}

}   // namespace angiopose::io
