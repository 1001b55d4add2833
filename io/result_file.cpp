#include "io/result_file.h"

#include "core/case/case_patients.h"
#include "core/case/case_views.h"
#include "core/geometry/angle_units.h"
#include "io/case/fields/bent_fields.h"
#include "io/case/fields/result_fields.h"
#include "io/check_point_table.h"
#include "io/edited_curves.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/json_text.h"
#include "io/support/message_json.h"

#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using Json = nlohmann::ordered_json;

/// What the tree calls its branches stands beside their ids.
void nameBranches(Json& branches, const core::Case& theCase)
{
    for (Json& branch : branches) {
        const core::VesselBranch* known =
            theCase.vessels.tree ? theCase.vessels.tree->find(branch.at("branch").get<int>()) : nullptr;
        if (known && !known->name.empty()) {
            branch["name"] = known->name;
        }
    }
}

/// File names only: results are passed around, and folders may name patients.
Json inputsJson(const core::Case& theCase, const core::RegistrationResult& result)
{
    Json inputs = Json::object();
    const auto add = [&](const char* key, const core::InputFile& file) {
        if (!file.path.empty()) {
            inputs[key]["file"] = std::filesystem::path(file.path).filename().string();
        }
        if (!file.path.empty() || !file.sha256.empty()) {
            inputs[key]["sha256"] = file.sha256;
        }
    };
    add("vessel", theCase.vessels.file);
    add("angiogram", theCase.shown().imageFile);
    add("centerline", exportedFileOf(theCase.shown().target));
    inputs["frame"] = result.provenance.frame.value_or(theCase.shown().frame);
    return inputs;
}

}   // namespace

std::string resultJson(const core::Case& theCase, const core::RegistrationResult& result)
{
    Json root;
    root["format"] = "angiopose-result";
    root["version"] = 1;
    root["title"] = theCase.title;
    root.update(writeFields(result, resultFields(), {}));
    for (const char* list : {"perBranch", "unfilled", "alternatives"}) {   // there even where they are empty
        if (!root.contains(list)) {
            root[list] = Json::array();
        }
    }
    if (!root.contains("programVersion")) {
        root["programVersion"] = ANGIOPOSE_VERSION;
    }
    nameBranches(root["perBranch"], theCase);
    nameBranches(root["unfilled"], theCase);
    root["warnings"] = sentencesOf(result.warnings);
    root["inputs"] = inputsJson(theCase, result);
    if (const core::Messages mismatch = core::findMismatch(theCase); !mismatch.empty()) {
        root["inputs"]["mismatch"] = sentencesOf(mismatch);
    }
    if (result.bent) {
        root["deformable"] = bentSummary(*result.bent);
    }
    if (!theCase.vessels.marks.empty()) {
        root["checkPoints"] = Json::parse(checkPointJson(theCase));
    }
    // File names and titles need not be UTF-8; the result must be written all the same.
    return prettyJson(root.dump(-1, ' ', false, Json::error_handler_t::replace));
}

core::Status writeResult(const core::Case& theCase, const core::RegistrationResult& result, const std::string& path)
{
    return writeAtomically(path, resultJson(theCase, result));
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

std::string jointJson(const core::RegisteredCase& registered)
{
    const core::MultiViewResult& joint = *registered.joint;
    Json json{{"format", "angiopose-joint-result"}, {"version", 1}, {"trustworthy", joint.trustworthy}};
    json["warnings"] = sentencesOf(joint.warnings);
    json["messages"] = Json::parse(messagesJson(joint.warnings));
    json["uncertainty"] = {{"inPlaneSigmaMm", joint.uncertainty.inPlaneMm},
                           {"depthSigmaMm", joint.uncertainty.depthMm},
                           {"rotationSigmaDeg", joint.uncertainty.rotationDeg.maxCoeff()}};
    for (std::size_t k = 0; k < registered.places.size(); ++k) {
        const core::Case showing = core::showingView(registered.theCase, registered.places[k]);
        Json view = Json::parse(resultJson(showing, *showing.shown().result));
        view.erase("deformable");   // of all views together: below
        view["view"] = registered.places[k] + 1;
        view["geometryCorrection"] = correctionJson(joint.corrections[k]);
        if (k < joint.cameras.size()) {
            view["cameraByAllViews"] = cameraJson(joint.cameras[k]);
        }
        json["views"].push_back(std::move(view));
    }
    if (const auto& bent = registered.result().bent) {
        json["deformable"] = bentSummary(*bent);
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}   // namespace

std::string registeredJson(const core::RegisteredCase& registered)
{
    return registered.joint ? jointJson(registered) : resultJson(registered.theCase, registered.result());
}

core::Status writeJointResult(const core::RegisteredCase& registered, const std::string& path)
{
    return writeAtomically(path, jointJson(registered));
}

}   // namespace angiopose::io