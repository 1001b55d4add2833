#include "io/case/case_document.h"
#include "io/case/geometry_values.h"
#include "io/case/known_keys.h"
#include "io/case/option_values.h"
#include "io/case/snapshot_json.h"
#include "io/case/tree_values.h"
#include "io/case/vessel_key.h"
#include "io/messages/says.h"
#include "io/support/json_text.h"
#include "io/support/pose_matrix.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using Json = nlohmann::json;

/// A member of an object; null where there is none.
const Json& member(const Json& json, const char* key)
{
    static const Json none;
    const auto found = json.is_object() ? json.find(key) : json.end();
    return found == json.end() ? none : *found;
}

/// Three numbers, as the schema has made sure.
Eigen::Vector3d pointFrom(const Json& json)
{
    return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

core::InputFile inputFile(const Json& json)
{
    return json.is_object() ? core::InputFile{json.value("path", ""), json.value("sha256", "")} : core::InputFile{};
}

core::VesselTracingOptions tracingOptions(const Json& json)
{
    core::VesselTracingOptions options;
    if (!json.is_object()) {
        return options;
    }
    if (const Json& threshold = member(json, "threshold"); threshold.is_number()) {
        options.threshold = threshold.get<double>();
    }
    for (const Json& seed : json.value("seedsInPatientMm", Json::array())) {
        options.seedsInPatient.push_back(pointFrom(seed));
    }
    for (const Json& point : json.value("avoidInPatientMm", Json::array())) {
        options.avoidInPatient.push_back(pointFrom(point));
    }
    if (const Json& root = member(json, "rootInPatientMm"); root.is_array()) {
        options.rootInPatient = pointFrom(root);
    }
    options.minBranchLengthMm = json.value("minBranchLengthMm", options.minBranchLengthMm);
    options.minBranchRadiusMm = json.value("minBranchRadiusMm", options.minBranchRadiusMm);
    options.pointSpacingMm = json.value("pointSpacingMm", options.pointSpacingMm);
    return options;
}

/// The tree as the user left it: it stands for what the input gives.
void readEditedTree(const Json& vessel, CaseDocument& document)
{
    const Json& edited = member(vessel, "editedTree");
    if (!edited.is_object()) {
        return;
    }
    auto tree = treeFromJson(edited.dump());
    if (!tree) {
        document.problems.push_back(says::caseEditedTree(tree.error().message).about("vessel.editedTree"));
        return;
    }
    document.values.vessels.tree = std::make_shared<const core::VesselTree>(std::move(tree).value());
    document.values.vessels.isTreeEdited = true;
}

std::string seriesIdOf(const Json& input)
{
    return member(input, "dicom").is_object() ? input["dicom"].value("seriesInstanceUid", "") : "";
}

/// A volume beside vessels of another kind is the scan they lie in.
void readScan(const Json& vessel, core::Case& values)
{
    const Json& scan = member(vessel, vesselKey(core::VesselInputKind::Volume));
    if (values.vessels.input.kind != core::VesselInputKind::Volume && scan.is_object()) {
        values.vessels.scanFile = inputFile(scan);
        values.vessels.scanSeriesId = seriesIdOf(scan);
    }
}

/// The first of the four kinds that the case names; centrelines before what they would be traced from.
void readVessel(const Json& vessel, CaseDocument& document)
{
    core::Case& values = document.values;
    values.vessels.auxiliaryBranchIds = vessel.value("auxiliaryBranches", std::vector<int>());
    values.vessels.excludedBranchIds = vessel.value("excludedBranches", std::vector<int>());
    values.vessels.hiddenBranchIds = vessel.value("hiddenBranches", std::vector<int>());
    if (const Json& pivot = member(vessel, "pivotInPatientMm"); pivot.is_array()) {
        values.vessels.pickedPivotInPatient = pointFrom(pivot);
    }
    readEditedTree(vessel, document);
    values.vessels.input.labels = vessel.value("labels", std::vector<int>());
    values.vessels.input.unitMm = vessel.value("unitMm", 1.0);
    values.vessels.input.tracing = tracingOptions(member(vessel, "tracing"));
    for (const core::VesselInputKind kind : vesselInputKinds) {
        const Json& input = member(vessel, vesselKey(kind));
        if (input.is_object()) {
            values.vessels.file = inputFile(input);
            values.vessels.input.kind = kind;
            values.vessels.input.seriesId = seriesIdOf(input);
            readScan(vessel, values);
            return;
        }
    }
    document.problems.push_back(says::caseNoInput().about("vessel"));
}

/// What is read of one view.
struct ReadView {
    core::View& values;
    ViewNotes& notes;
    core::Messages& problems;
};

/// A 2-D centreline edited in the window says so, and for which frame.
void readTarget(const Json& centerline, core::View& view)
{
    view.target.file = inputFile(centerline);
    if (centerline.is_object() && centerline.value("origin", "") == "edited") {
        view.target.editedFrame = centerline.value("frame", view.frame);
        view.target.acceptedCurveIds = centerline.value("acceptedCurves", std::vector<int>());
    }
}

/// What is absent stays as the image's header has it, so the notes keep it open until that is read.
void readSubtraction(const Json& json, ReadView& view)
{
    if (!json.is_object()) {
        return;
    }
    SubtractionKeys& keys = view.notes.subtraction.emplace();
    core::RunTreatment& treatment = view.values.treatment;
    treatment.isSubtracted = json.value("on", true);
    treatment.isComposite = json.value("composite", "none") == "minimum";
    if (const Json& frames = member(json, "maskFrames"); frames.is_array()) {
        keys.maskFrames = frames.get<std::vector<int>>();
    }
    if (const Json& interval = member(json, "interval"); interval.is_object()) {
        keys.interval = core::MaskInterval{interval.value("offset", 1), std::nullopt};
        if (interval.contains("reversedFrom")) {
            keys.interval->reversedFrom = interval["reversedFrom"].get<int>();
        }
    }
    if (const Json& shift = member(json, "maskShiftPx"); shift.is_array()) {
        keys.maskShiftPx = Eigen::Vector2d(shift[0].get<double>(), shift[1].get<double>());
    }
    keys.isShiftAutomatic = member(json, "maskShiftPx").is_string();
    if (const Json& relation = member(json, "pixelRelation"); relation.is_string()) {
        keys.relation = relation == "logarithmic" ? core::PixelRelation::Logarithmic : core::PixelRelation::Linear;
    }
    if (const Json& vessels = member(json, "vessels"); vessels.is_string()) {
        treatment.polarity = vessels == "bright" ? core::Polarity::VesselsBright : core::Polarity::VesselsDark;
    }
}

void readAngiogram(const Json& angiogram, ReadView& view)
{
    core::View& values = view.values;
    const Json& image = member(angiogram, "image");
    values.imageFile = inputFile(image);
    view.notes.sopInstanceUid = member(image, "dicom").is_object() ? image["dicom"].value("sopInstanceUid", "") : "";
    view.notes.hasFrame = angiogram.contains("frame");
    values.frame = angiogram.value("frame", 0);
    readTarget(member(angiogram, "centerline"), values);
    readSubtraction(member(angiogram, "subtraction"), view);
    if (const Json& trace = member(angiogram, "trace"); trace.is_object()) {
        core::TraceOptions& options = values.traceOptions;
        options.minVesselRadiusPx = trace.value("minVesselRadiusPx", options.minVesselRadiusPx);
        options.maxVesselRadiusPx = trace.value("maxVesselRadiusPx", options.maxVesselRadiusPx);
        options.minBranchLengthPx = trace.value("minBranchLengthPx", options.minBranchLengthPx);
        options.minComponentLengthPx = trace.value("minComponentLengthPx", options.minComponentLengthPx);
        options.sensitivity = trace.value("sensitivity", options.sensitivity);
        if (options.maxVesselRadiusPx < options.minVesselRadiusPx) {
            view.problems.push_back(says::caseRadiiSwapped().about("angiogram.trace"));
        }
    }
}

/// The pose under `pose.<key>`, when it is there and makes sense.
std::optional<core::RigidTransform> readPose(const Json& poses, const char* key, core::Messages& problems)
{
    const Json& pose = member(poses, key);
    if (!pose.is_object()) {
        return std::nullopt;
    }
    const auto result = poseFromRows(pose["cameraFromPatient"].get<MatrixRows>());
    if (!result) {
        problems.push_back(result.error().message.about(std::string("pose.") + key));
        return std::nullopt;
    }
    return result.value();
}

void readPoses(const Json& poses, ReadView& view)
{
    view.values.initialCameraFromPatient = readPose(poses, "initial", view.problems);
    if (const auto current = readPose(poses, "current", view.problems)) {
        view.values.cameraFromPatient = *current;
        view.notes.hasCurrentPose = true;
    }
    for (const Json& landmark : poses.is_object() ? poses.value("landmarks", Json::array()) : Json::array()) {
        view.values.landmarks.push_back(
            {pointFrom(landmark["pointInPatientMm"]),
             Eigen::Vector2d(landmark["pixel"][0].get<double>(), landmark["pixel"][1].get<double>()),
             landmark.value("name", "")});
    }
}

void readLocks(const Json& poses, core::PoseLocks& locks)
{
    for (const Json& id : member(poses, "locked")) {
        if (const auto axis = core::poseAxisFrom(id.get<std::string>())) {   // the schema knows no others
            locks[static_cast<std::size_t>(*axis)] = true;
        }
    }
}

void readOptions(const Json& root, CaseDocument& document)
{
    core::RegistrationOptions& options = document.values.options;
    options.method = root.value("method", options.method);
    const bool isDefault = options.method == core::RegistrationOptions().method;
    const auto methods = core::methodInfos();
    if (!isDefault &&
        std::none_of(methods.begin(), methods.end(), [&](const auto& info) { return info.id == options.method; })) {
        std::vector<std::string> known;
        for (const core::MethodInfo& info : methods) {
            known.emplace_back(info.id);
        }
        document.problems.push_back(says::caseMethodUnknown(options.method.substr(0, 40), known).about("method"));
    }
    const Json& given = member(root, "options");
    for (const core::OptionField& field : core::optionFields()) {
        const Json& value = member(given, std::string(field.key).c_str());
        if (value.is_null()) {
            continue;
        }
        const auto number = value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
        const std::string text = value.is_string() ? value.get<std::string>() : std::string();
        if (const auto problem = setOption(options, field, number, text)) {
            document.problems.push_back(*problem);
        }
    }
}

/// Image, geometry and poses, of the case itself or of a view that stands in it.
void readView(const Json& json, ReadView view)
{
    readAngiogram(json["angiogram"], view);
    readGeometry(json.value("geometry", Json::object()).dump(), view.values.geometry, view.problems);
    readPoses(member(json, "pose"), view);
    if (const Json& snapshots = member(json, "snapshots"); snapshots.is_array()) {
        view.values.snapshots = snapshotsFromJson(snapshots.dump(), view.problems);
    }
}

/// A case file of its own, or what a case says about a view.
void readOtherView(const Json& json, CaseDocument& document)
{
    core::View& view = document.values.views.emplace_back();
    ViewNotes& notes = document.notes.emplace_back();
    if (!json.contains("angiogram")) {
        view.caseFile = inputFile(json);
        return;
    }
    core::Messages problems;
    readView(json, {view, notes, problems});
    view.extraKeys = unknownKeys(json.dump(), knownViewKeys());
    for (const core::Message& problem : problems) {
        document.problems.push_back(problem.about("views"));
    }
}

/// What this version does not know goes with the view it belongs to.
void readUnknown(std::string_view json, core::Case& values)
{
    const std::string unknown = unknownKeys(json, knownCaseKeys(values.vessels.input.kind));
    Json ofCase = unknown.empty() ? Json::object() : Json::parse(unknown);
    Json ofView = Json::object();
    for (const char* key : {"angiogram", "geometry", "pose"}) {
        if (ofCase.contains(key)) {
            ofView[key] = ofCase[key];
            ofCase.erase(key);
        }
    }
    values.extraKeys = ofCase.empty() ? std::string() : ofCase.dump();
    values.shown().extraKeys = ofView.empty() ? std::string() : ofView.dump();
}

}   // namespace

CaseDocument parseCaseDocument(std::string_view json)
{
    const Json root = Json::parse(json);
    CaseDocument document;
    if (root["version"].get<double>() > 1.0) {
        document.problems.push_back(says::caseNewer().about("version"));
        return document;
    }
    document.values.title = root.value("title", "");
    readVessel(root["vessel"], document);
    readView(root, {document.values.shown(), document.notes.emplace_back(), document.problems});
    for (const Json& view : member(root, "views")) {
        readOtherView(view, document);
    }
    readOptions(root, document);
    readLocks(member(root, "pose"), document.values.options.locks);
    readUnknown(json, document.values);
    return document;
}

}   // namespace angiopose::io