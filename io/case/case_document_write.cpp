#include "io/case/case_document.h"
#include "io/case/option_values.h"
#include "io/case/snapshot_json.h"
#include "io/case/tree_values.h"
#include "io/case/vessel_key.h"
#include "io/support/json_text.h"
#include "io/support/pose_matrix.h"

#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using core::Origin;
using core::Sourced;
using Json = nlohmann::ordered_json;

std::string originText(Origin origin)
{
    switch (origin) {
        case Origin::Header:
            return "header";
        case Origin::Derived:
            return "derived";
        case Origin::Assumed:
            return "assumed";
        default:
            return "user";
    }
}

Json fileJson(const core::InputFile& file, const std::filesystem::path& folder)
{
    std::error_code failed;
    const std::filesystem::path target = std::filesystem::weakly_canonical(file.path, failed);
    const std::filesystem::path relative = target.lexically_relative(folder);
    Json json;
    json["path"] = (failed || relative.empty() ? std::filesystem::path(file.path) : relative).generic_string();
    if (!file.sha256.empty()) {
        json["sha256"] = file.sha256;
    }
    return json;
}

template <class Value>
void addSourced(Json& geometry, const char* key, const Value& value, Origin origin, const std::string& basis)
{
    geometry[key]["value"] = value;
    geometry[key]["origin"] = originText(origin);
    if (!basis.empty()) {
        geometry[key]["basis"] = basis;
    }
}

void addNumber(Json& geometry, const char* key, const Sourced<double>& number)
{
    if (number.value) {
        addSourced(geometry, key, *number.value, number.origin, number.basis);
    }
}

Json pointJson(const Eigen::Vector3d& point)
{
    return Json::array({point.x(), point.y(), point.z()});
}

Json tracingJson(const core::VesselTracingOptions& options)
{
    Json json{{"minBranchLengthMm", options.minBranchLengthMm},
              {"minBranchRadiusMm", options.minBranchRadiusMm},
              {"pointSpacingMm", options.pointSpacingMm}};
    if (options.threshold) {
        json["threshold"] = *options.threshold;
    }
    for (const Eigen::Vector3d& seed : options.seedsInPatient) {
        json["seedsInPatientMm"].push_back(pointJson(seed));
    }
    for (const Eigen::Vector3d& point : options.avoidInPatient) {
        json["avoidInPatientMm"].push_back(pointJson(point));
    }
    if (options.rootInPatient) {
        json["rootInPatientMm"] = pointJson(*options.rootInPatient);
    }
    return json;
}

Json vesselJson(const core::Case& theCase, const std::filesystem::path& folder)
{
    const core::VesselInput& input = theCase.vessels.input;
    Json vessel;
    Json& file = vessel[vesselKey(input.kind)];
    file = fileJson(theCase.vessels.file, folder);
    if (!input.seriesId.empty()) {
        file["dicom"]["seriesInstanceUid"] = input.seriesId;
    }
    if (input.kind != core::VesselInputKind::Volume && !theCase.vessels.scanFile.path.empty()) {
        Json& scan = vessel[vesselKey(core::VesselInputKind::Volume)];
        scan = fileJson(theCase.vessels.scanFile, folder);
        if (!theCase.vessels.scanSeriesId.empty()) {
            scan["dicom"]["seriesInstanceUid"] = theCase.vessels.scanSeriesId;
        }
    }
    if (input.kind != core::VesselInputKind::Centerline) {
        vessel["tracing"] = tracingJson(input.tracing);
    }
    if (!input.labels.empty()) {
        vessel["labels"] = input.labels;
    }
    if (input.unitMm != 1.0) {
        vessel["unitMm"] = input.unitMm;
    }
    vessel["auxiliaryBranches"] = theCase.vessels.auxiliaryBranchIds;
    vessel["excludedBranches"] = theCase.vessels.excludedBranchIds;
    if (!theCase.vessels.hiddenBranchIds.empty()) {
        vessel["hiddenBranches"] = theCase.vessels.hiddenBranchIds;
    }
    if (theCase.vessels.pickedPivotInPatient) {
        vessel["pivotInPatientMm"] = pointJson(*theCase.vessels.pickedPivotInPatient);
    }
    if (theCase.vessels.isTreeEdited && theCase.vessels.tree) {
        vessel["editedTree"] = Json::parse(treeJson(*theCase.vessels.tree));
    }
    return vessel;
}

Json targetJson(const core::View& view, const std::filesystem::path& folder)
{
    Json target = fileJson(view.target.file, folder);
    if (view.target.editedFrame) {
        target["origin"] = "edited";
        target["frame"] = *view.target.editedFrame;
        target["acceptedCurves"] = view.target.acceptedCurveIds;
    }
    return target;
}

Json subtractionJson(const core::RunTreatment& treatment)
{
    const core::SubtractionPlan& plan = treatment.plan;
    Json json{{"on", treatment.isSubtracted}, {"composite", treatment.isComposite ? "minimum" : "none"}};
    json["maskFrames"] = plan.maskFrames;
    if (plan.interval) {
        json["interval"]["offset"] = plan.interval->offset;
        if (plan.interval->reversedFrom) {
            json["interval"]["reversedFrom"] = *plan.interval->reversedFrom;
        }
    }
    if (plan.maskShiftPx) {
        json["maskShiftPx"] = {plan.maskShiftPx->x(), plan.maskShiftPx->y()};
    } else {
        json["maskShiftPx"] = "automatic";
    }
    json["pixelRelation"] = plan.relation == core::PixelRelation::Linear ? "linear" : "logarithmic";
    if (treatment.polarity) {
        json["vessels"] = treatment.polarity == core::Polarity::VesselsBright ? "bright" : "dark";
    }
    return json;
}

Json angiogramJson(const core::View& view, const std::filesystem::path& folder)
{
    Json angiogram;
    angiogram["image"] = fileJson(view.imageFile, folder);
    if (view.angiogram && !view.angiogram->identity.sopInstanceUid.empty()) {
        const core::StudyIdentity& identity = view.angiogram->identity;
        angiogram["image"]["dicom"] = {{"studyInstanceUid", identity.studyUid},
                                       {"seriesInstanceUid", identity.seriesUid},
                                       {"sopInstanceUid", identity.sopInstanceUid}};
    }
    angiogram["frame"] = view.frame;
    if (!view.target.file.path.empty()) {
        angiogram["centerline"] = targetJson(view, folder);
    }
    if (view.treatment != core::RunTreatment{.plan = view.headerPlan}) {
        angiogram["subtraction"] = subtractionJson(view.treatment);
    }
    const core::TraceOptions& trace = view.traceOptions;
    angiogram["trace"] = {{"minVesselRadiusPx", trace.minVesselRadiusPx},
                          {"maxVesselRadiusPx", trace.maxVesselRadiusPx},
                          {"minBranchLengthPx", trace.minBranchLengthPx},
                          {"minComponentLengthPx", trace.minComponentLengthPx},
                          {"sensitivity", trace.sensitivity}};
    return angiogram;
}

Json geometryJson(const core::ViewGeometry& values)
{
    Json geometry = Json::object();
    if (const auto& camera = values.cameraOverride) {
        geometry["camera"] = {{"fx", camera->fx}, {"fy", camera->fy},       {"cx", camera->cx},
                              {"cy", camera->cy}, {"width", camera->width}, {"height", camera->height}};
    }
    const core::CArm& cArm = values.cArm;
    addNumber(geometry, "sourceToDetectorMm", cArm.sourceToDetectorMm);
    addNumber(geometry, "sourceToPatientMm", cArm.sourceToPatientMm);
    if (cArm.rowSpacingMm.value && cArm.columnSpacingMm.value) {
        addSourced(geometry, "imagerPixelSpacingMm",
                   std::vector<double>{*cArm.rowSpacingMm.value, *cArm.columnSpacingMm.value},
                   cArm.columnSpacingMm.origin, cArm.columnSpacingMm.basis);
    }
    addNumber(geometry, "primaryAngleDeg", cArm.primaryAngleDeg);
    addNumber(geometry, "secondaryAngleDeg", cArm.secondaryAngleDeg);
    addNumber(geometry, "rollDeg", cArm.rollDeg);
    if (const auto& point = cArm.principalPointPx; point.value) {
        addSourced(geometry, "principalPointPx", std::vector<double>{point.value->x(), point.value->y()}, point.origin,
                   point.basis);
    }
    if (const auto& point = cArm.isocentreInPatientMm; point.value) {
        addSourced(geometry, "isocentreInPatientMm", pointJson(*point.value), point.origin, point.basis);
    }
    if (const auto& mirrored = cArm.mirrored; mirrored.value) {
        addSourced(geometry, "mirrored", *mirrored.value, mirrored.origin, mirrored.basis);
    }
    return geometry;
}

Json lockedJson(const core::PoseLocks& locks)
{
    Json ids = Json::array();
    for (const core::PoseAxis axis : core::poseAxes) {
        if (core::isLocked(locks, axis)) {
            ids.push_back(core::idOf(axis));
        }
    }
    return ids;
}

Json landmarkJson(const core::Landmark& landmark)
{
    Json json{{"pointInPatientMm", pointJson(landmark.pointInPatient)},
              {"pixel", {landmark.pixel.x(), landmark.pixel.y()}}};
    if (!landmark.name.empty()) {
        json["name"] = landmark.name;
    }
    return json;
}

Json poseJson(const core::View& view)
{
    Json pose;
    if (view.initialCameraFromPatient) {
        pose["initial"]["cameraFromPatient"] = rowsOf(*view.initialCameraFromPatient);
    }
    pose["current"]["cameraFromPatient"] = rowsOf(view.cameraFromPatient);
    for (const core::Landmark& landmark : view.landmarks) {
        pose["landmarks"].push_back(landmarkJson(landmark));
    }
    return pose;
}

void addSnapshots(Json& json, const core::View& view)
{
    if (!view.snapshots.empty()) {
        json["snapshots"] = Json::parse(snapshotsJson(view.snapshots));
    }
}

Json otherViewJson(const core::View& view, const std::filesystem::path& folder)
{
    if (!view.caseFile.path.empty()) {
        return fileJson(view.caseFile, folder);
    }
    Json json{{"angiogram", angiogramJson(view, folder)},
              {"geometry", geometryJson(view.geometry)},
              {"pose", poseJson(view)}};
    addSnapshots(json, view);
    return Json::parse(withExtraKeys(json.dump(), view.extraKeys));
}

}   // namespace

std::string caseDocumentText(const core::Case& theCase, const std::filesystem::path& folder)
{
    Json root;
    root["format"] = "angiopose-case";
    root["version"] = 1;
    root["title"] = theCase.title;
    root["vessel"] = vesselJson(theCase, folder);
    const core::View& shown = theCase.shown();
    root["angiogram"] = angiogramJson(shown, folder);
    root["geometry"] = geometryJson(shown.geometry);
    root["pose"] = poseJson(shown);
    if (core::isAnyLocked(theCase.options.locks)) {
        root["pose"]["locked"] = lockedJson(theCase.options.locks);
    }
    for (const core::View& view : theCase.views) {
        if (&view != &shown) {
            root["views"].push_back(otherViewJson(view, folder));
        }
    }
    root["method"] = theCase.options.method;
    root["options"] = Json::parse(optionsJson(theCase.options));
    addSnapshots(root, shown);
    return prettyJson(withExtraKeys(withExtraKeys(root.dump(), shown.extraKeys), theCase.extraKeys));
}

}   // namespace angiopose::io