#include "io/results/result_file.h"

#include "core/case/case_patients.h"
#include "core/case/case_views.h"
#include "core/geometry/angle_units.h"
#include "io/case/deidentified_case.h"
#include "io/case/fields/deformation_fields.h"
#include "io/case/fields/geometry_fields.h"
#include "io/case/fields/result_fields.h"
#include "io/case/input_case.h"
#include "io/edited_curves.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/json_text.h"
#include "io/support/message_json.h"
#include "io/target_point_table.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using Json = nlohmann::ordered_json;

/// Adds the names that branches have in the tree to their IDs.
void nameBranches(Json& branches, const core::Case& session)
{
    for (Json& branch : branches) {
        const core::VesselBranch* known =
            session.vessels.tree ? session.vessels.tree->find(branch.at("branch").get<int>()) : nullptr;
        if (known && !known->name.empty()) {
            branch["name"] = known->name;
        }
    }
}

Json uidsOf(const core::StudyIdentity& identity)
{
    Json uids = Json::object();
    const auto add = [&uids](const char* key, const std::string& uid) {
        if (!uid.empty()) {
            uids[key] = uid;
        }
    };
    add("studyInstanceUid", identity.studyUid);
    add("seriesInstanceUid", identity.seriesUid);
    add("sopInstanceUid", identity.sopInstanceUid);
    return uids;
}

/// Returns file names without folders, because results are shared and folder names may identify patients.
Json inputsJson(const core::Case& session, const core::RegistrationResult& result)
{
    Json inputs = Json::object();
    const auto add = [&](const char* key, const core::InputFile& file, const core::StudyIdentity* identity) {
        if (!file.path.empty()) {
            inputs[key]["file"] = std::filesystem::path(file.path).filename().string();
        }
        if (!file.path.empty() || !file.sha256.empty()) {
            inputs[key]["sha256"] = file.sha256;
        }
        if (const Json uids = identity ? uidsOf(*identity) : Json::object(); !uids.empty()) {
            inputs[key]["dicom"] = uids;
        }
    };
    const auto& angiogram = session.shown().angiogram;
    add("vessel", session.vessels.file, &session.vessels.scanIdentity);
    add("angiogram", session.shown().imageFile, angiogram ? &angiogram->identity : nullptr);
    add("centerline", exportedFile(session.shown().target), nullptr);
    inputs["frame"] = result.provenance.frame.value_or(session.shown().frame);
    return inputs;
}

/// Adds the camera of the view, if known, and the origin of its values.
void addGeometry(Json& root, const core::View& view)
{
    if (const auto known = core::cameraOf(view)) {
        const core::ProjectionCamera& camera = known.value();
        root["projection"] = {{"fx", camera.fx}, {"fy", camera.fy},       {"cx", camera.cx},
                              {"cy", camera.cy}, {"width", camera.width}, {"height", camera.height}};
    }
    root["geometry"] = writeFields(view.geometry, geometryFields(), {});
}

void eraseUids(Json& json)
{
    if (json.is_object()) {
        json.erase("dicom");
    }
    if (json.is_structured()) {
        std::ranges::for_each(json, eraseUids);
    }
}

/// Removes UIDs and the warnings about a patient mismatch between the images.
std::string withoutUids(const std::string& result)
{
    Json root = Json::parse(result);
    root["inputs"].erase("mismatch");
    eraseUids(root);
    return prettyJson(root.dump());
}

}   // namespace

std::string resultJson(const core::Case& session, const core::RegistrationResult& result, const std::string& inputCase)
{
    Json root;
    root["format"] = "angiopose-result";
    root["version"] = 2;
    root["view"] = session.shownView + 1;
    root["title"] = session.title;
    root.update(writeFields(result, resultFields(), {}));
    for (const char* list : {"perBranch", "unfilled", "alternatives"}) {   // lists are present even if they are empty
        if (!root.contains(list)) {
            root[list] = Json::array();
        }
    }
    if (!root.contains("programVersion")) {
        root["programVersion"] = ANGIOPOSE_VERSION;
    }
    nameBranches(root["perBranch"], session);
    nameBranches(root["unfilled"], session);
    root["warnings"] = sentencesOf(result.warnings);
    root["inputs"] = inputsJson(session, result);
    if (const core::Messages mismatch = core::findMismatch(session); !mismatch.empty()) {
        root["inputs"]["mismatch"] = sentencesOf(mismatch);
    }
    if (result.deformed) {
        root["deformable"] = deformationSummary(*result.deformed);
        if (result.deformed->verdict != core::DeformationVerdict::Rigid) {
            root["bent"] = deformationField().write(result, {});
        }
    }
    addGeometry(root, session.shown());
    if (!inputCase.empty()) {
        root["case"] = Json::parse(inputCase);
    }
    if (!session.vessels.marks.empty()) {
        root["checkPoints"] = Json::parse(targetPointJson(session));
    }
    // Replace invalid bytes: file names and titles need not be UTF-8, but the result must be written anyway.
    return prettyJson(root.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string resultJson(const core::RegisteredCase& registered, std::size_t viewPosition, ResultTexts names)
{
    const core::Case showing = core::withShownView(registered.session, viewPosition);
    if (names == ResultTexts::Kept) {
        return resultJson(showing, *showing.shown().result, inputCaseJson(registered));
    }
    const core::Case nameless = deidentifyCase(showing);
    const std::string asked = registered.asked ? inputCaseJson(deidentifyCase(*registered.asked)) : std::string();
    return withoutUids(resultJson(nameless, *nameless.shown().result, asked));
}

std::string storedResultJson(const core::Case& session, ResultTexts names)
{
    core::Case ofRun = keepJointlyRegisteredViews(session);
    if (names == ResultTexts::Kept) {
        return resultJson(ofRun, *ofRun.shown().result, inputCaseJsonFromResult(ofRun));
    }
    ofRun = deidentifyCase(std::move(ofRun));
    return withoutUids(resultJson(ofRun, *ofRun.shown().result, inputCaseJsonFromResult(ofRun)));
}

core::Status writeResult(const core::Case& session, const std::string& path)
{
    return writeAtomically(path, storedResultJson(session, ResultTexts::Kept));
}

namespace {

Json correctionJson(const core::Vector6d& correction)
{
    return {{"turnDeg", core::degreesPerRadian * correction.head<3>().norm()},
            {"shiftMm", correction.tail<3>().norm()}};
}

Json cameraJson(const core::CameraEvidence& camera)
{
    const auto three = [](const core::CameraError& values) { return Json{values[0], values[1], values[2]}; };
    return {{"error", three(camera.error)}, {"sigma", three(camera.std)}, {"gain", camera.gain}};
}

std::string jointJson(const core::RegisteredCase& registered, const std::string& inputCase)
{
    const core::MultiViewResult& joint = *registered.joint;
    Json json{{"format", "angiopose-joint-result"}, {"version", 1}, {"trustworthy", joint.trustworthy}};
    json["warnings"] = sentencesOf(joint.warnings);
    json["messages"] = Json::parse(messagesJson(joint.warnings));
    json["uncertainty"] = {{"inPlaneSigmaMm", joint.uncertainty.inPlaneMm},
                           {"depthSigmaMm", joint.uncertainty.depthMm},
                           {"rotationSigmaDeg", joint.uncertainty.rotationDeg.maxCoeff()}};
    for (std::size_t k = 0; k < registered.viewIndices.size(); ++k) {
        const core::Case showing = core::withShownView(registered.session, registered.viewIndices[k]);
        Json view = Json::parse(resultJson(showing, *showing.shown().result, inputCase));
        view.erase("deformable");   // belongs to all views together and is added below
        view.erase("case");
        view["view"] = registered.viewIndices[k] + 1;
        view["geometryCorrection"] = correctionJson(joint.corrections[k]);
        if (k < joint.cameras.size()) {
            view["cameraByAllViews"] = cameraJson(joint.cameras[k]);
        }
        json["views"].push_back(std::move(view));
    }
    if (!inputCase.empty()) {
        json["case"] = Json::parse(inputCase);
    }
    if (const auto& deformed = registered.result().deformed) {
        json["deformable"] = deformationSummary(*deformed);
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}   // namespace

std::string registrationJson(const core::RegisteredCase& registered, const std::string& inputCase)
{
    return registered.joint ? jointJson(registered, inputCase)
                            : resultJson(registered.session, registered.result(), inputCase);
}

core::Status writeJointResult(const core::RegisteredCase& registered, const std::string& path,
                              const std::string& inputCase)
{
    return writeAtomically(path, jointJson(registered, inputCase));
}

}   // namespace angiopose::io
