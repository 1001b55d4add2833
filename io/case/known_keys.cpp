#include "io/case/known_keys.h"

#include "core/registration/registration_options.h"
#include "io/case/vessel_key.h"

#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using Json = nlohmann::json;

Json object(std::initializer_list<const char*> keys)
{
    Json members = Json::object();
    for (const char* key : keys) {
        members[key] = "";
    }
    return members;
}

}   // namespace

std::string knownCaseKeys(core::VesselInputKind vesselKind)
{
    const Json file = object({"path", "sha256"});
    const Json sourced = object({"value", "origin", "basis"});
    Json image = file;
    image["dicom"] = object({"studyInstanceUid", "seriesInstanceUid", "sopInstanceUid"});

    Json keys = object({"format", "version", "title", "views", "method", "snapshots"});
    Json vessel = file;
    vessel["dicom"] = object({"seriesInstanceUid"});
    keys["vessel"] = object({"auxiliaryBranches", "excludedBranches", "hiddenBranches", "pivotInPatientMm",
                             "editedTree", "labels", "unitMm"});
    keys["vessel"][vesselKey(vesselKind)] = vessel;   // another kind beside it is kept, not read,
    keys["vessel"][vesselKey(core::VesselInputKind::Volume)] = vessel;   // but for a scan
    keys["vessel"]["tracing"] = object({"threshold", "seedsInPatientMm", "avoidInPatientMm", "rootInPatientMm",
                                        "minBranchLengthMm", "minBranchRadiusMm", "pointSpacingMm"});
    keys["angiogram"] = object({"frame"});
    keys["angiogram"]["image"] = image;
    keys["angiogram"]["centerline"] = object({"path", "sha256", "origin", "frame", "acceptedCurves"});
    keys["angiogram"]["subtraction"] =
        object({"on", "composite", "maskFrames", "maskShiftPx", "pixelRelation", "vessels"});
    keys["angiogram"]["subtraction"]["interval"] = object({"offset", "reversedFrom"});
    keys["angiogram"]["trace"] =
        object({"minVesselRadiusPx", "maxVesselRadiusPx", "minBranchLengthPx", "minComponentLengthPx", "sensitivity"});
    keys["geometry"]["camera"] = object({"fx", "fy", "cx", "cy", "width", "height"});
    for (const char* key : {"sourceToDetectorMm", "sourceToPatientMm", "imagerPixelSpacingMm", "primaryAngleDeg",
                            "secondaryAngleDeg", "rollDeg", "principalPointPx", "mirrored", "isocentreInPatientMm"}) {
        keys["geometry"][key] = sourced;
    }
    keys["pose"] = object({"landmarks"});
    keys["pose"]["initial"] = object({"cameraFromPatient"});
    keys["pose"]["current"] = object({"cameraFromPatient"});
    keys["pose"]["locked"] = "";
    keys["options"] = Json::object();
    for (const core::OptionField& field : core::optionFields()) {
        keys["options"][std::string(field.key)] = "";
    }
    return keys.dump();
}

std::string knownViewKeys()
{
    const Json all = Json::parse(knownCaseKeys(core::VesselInputKind::Centerline));
    Json keys = object({"snapshots"});
    for (const char* key : {"angiogram", "geometry", "pose"}) {
        keys[key] = all[key];
    }
    return keys.dump();
}

}   // namespace angiopose::io