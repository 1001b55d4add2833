#include "io/result_file.h"

#include "io/case/fields/option_values.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/json_text.h"
#include "io/support/message_json.h"
#include "io/support/pose_matrix.h"

#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using Json = nlohmann::ordered_json;

Json metricsJson(const core::DistanceMetrics& metrics)
{
    return {{"meanProjectionDistancePx", metrics.meanPx},
            {"medianProjectionDistancePx", metrics.medianPx},
            {"p75ProjectionDistancePx", metrics.p75Px},
            {"p95ProjectionDistancePx", metrics.p95Px},
            {"meanProjectionDistanceMm", metrics.meanMm},
            {"medianProjectionDistanceMm", metrics.medianMm},
            {"p75ProjectionDistanceMm", metrics.p75Mm},
            {"p95ProjectionDistanceMm", metrics.p95Mm},
            {"coverage", metrics.coverage},
            {"reverseDistancePx", metrics.reverseMeanPx},
            {"reverseDistanceMm", metrics.reverseMeanMm}};
}

Json uncertaintyJson(const core::PoseUncertainty& uncertainty)
{
    MatrixRows covariance(6, std::vector<double>(6));
    Json weakest = Json::array();
    for (int i = 0; i < 6; ++i) {
        for (int k = 0; k < 6; ++k) {
            covariance[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = uncertainty.covariance(i, k);
        }
        weakest.push_back(uncertainty.weakestDirection(i));
    }
    const Eigen::Vector3d& rotation = uncertainty.rotationDeg;
    return {{"order", {"rotationX", "rotationY", "rotationZ", "x", "y", "z"}},
            {"units", {"rad", "rad", "rad", "mm", "mm", "mm"}},
            {"frame", "camera axes about the centroid of the vessel tree"},
            {"covariance", covariance},
            {"rotationSigmaDeg", {rotation.x(), rotation.y(), rotation.z()}},
            {"inPlaneSigmaMm", uncertainty.inPlaneMm},
            {"depthSigmaMm", uncertainty.depthMm},
            {"observed", uncertainty.observed},
            {"weakestDirection", weakest}};
}

Json branchesJson(const core::Case& theCase, const core::RegistrationResult& result)
{
    Json branches = Json::array();
    for (const core::BranchResidual& branch : result.branches) {
        Json json = {{"branch", branch.branchId},
                     {"points", branch.pointCount},
                     {"medianPx", branch.medianPx},
                     {"p95Px", branch.p95Px},
                     {"agreement", branch.agreement}};
        const core::VesselBranch* known = theCase.vessels.tree ? theCase.vessels.tree->find(branch.branchId) : nullptr;
        if (known && !known->name.empty()) {
            json["name"] = known->name;
        }
        branches.push_back(std::move(json));
    }
    return branches;
}

Json alternativesJson(const core::RegistrationResult& result)
{
    Json alternatives = Json::array();
    for (const core::Hypothesis& hypothesis : result.alternatives) {
        alternatives.push_back(
            {{"cameraFromPatient", rowsOf(hypothesis.cameraFromPatient)}, {"score", hypothesis.score}});
    }
    return alternatives;
}

/// File names only: results are passed around, and folders may name patients.
Json inputsJson(const core::Case& theCase)
{
    Json inputs = Json::object();
    const auto add = [&](const char* key, const core::InputFile& file) {
        if (!file.path.empty()) {
            inputs[key] = {{"file", std::filesystem::path(file.path).filename().string()}, {"sha256", file.sha256}};
        }
    };
    add("vessel", theCase.vessels.file);
    add("angiogram", theCase.shown().imageFile);
    add("centerline", theCase.shown().target.file);
    inputs["frame"] = theCase.shown().frame;
    return inputs;
}

}   // namespace

std::string resultJson(const core::Case& theCase, const core::RegistrationResult& result)
{
    Json root;
    root["format"] = "angiopose-result";
    root["version"] = 1;
    root["title"] = theCase.title;
    root["method"] = result.method;
    root["pose"]["cameraFromPatient"] = rowsOf(result.cameraFromPatient);
    root["metrics"] = metricsJson(result.metrics);
    root["uncertainty"] = uncertaintyJson(result.uncertainty);
    root["perBranch"] = branchesJson(theCase, result);
    root["alternatives"] = alternativesJson(result);
    root["trustworthy"] = result.trustworthy;
    root["warnings"] = sentencesOf(result.warnings);
    root["messages"] = Json::parse(messagesJson(result.warnings));
    root["stopReason"] = core::toText(result.stopReason);
    root["iterations"] = result.iterations;
    root["timeMs"] = {{"target", result.time.targetMs},
                      {"search", result.time.searchMs},
                      {"solve", result.time.solveMs},
                      {"total", result.time.totalMs}};
    root["inputs"] = inputsJson(theCase);
    root["options"] = Json::parse(optionsJson(theCase.options));
    root["programVersion"] = ANGIOPOSE_VERSION;
    // File names and titles need not be UTF-8; the result must be written all the same.
    return prettyJson(root.dump(-1, ' ', false, Json::error_handler_t::replace));
}

core::Status writeResult(const core::Case& theCase, const core::RegistrationResult& result, const std::string& path)
{
    return writeAtomically(path, resultJson(theCase, result));
}

}   // namespace angiopose::io