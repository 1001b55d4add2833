#include "io/result_file.h"

#include "io/support/atomic_file.h"
#include "io/support/rigid_rows.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace io {
namespace {

using Json = nlohmann::ordered_json;

Json metricsJson(const core::DistanceMetrics& metrics)
{
    return {{"meanProjectionDistancePx", metrics.meanPx},
            {"meanProjectionDistanceMm", metrics.meanMm},
            {"medianProjectionDistancePx", metrics.medianPx},
            {"medianProjectionDistanceMm", metrics.medianMm},
            {"p75ProjectionDistancePx", metrics.p75Px},
            {"p75ProjectionDistanceMm", metrics.p75Mm},
            {"p95ProjectionDistancePx", metrics.p95Px},
            {"p95ProjectionDistanceMm", metrics.p95Mm},
            {"coverage", metrics.coverage},
            {"reverseDistancePx", metrics.reverseMeanPx},
            {"reverseDistanceMm", metrics.reverseMeanMm}};
}

Json uncertaintyJson(const core::PoseUncertainty& uncertainty)
{
    Json covariance = Json::array();
    for (int row = 0; row < 6; ++row) {
        Json values = Json::array();
        for (int column = 0; column < 6; ++column) {
            values.push_back(uncertainty.covariance(row, column));
        }
        covariance.push_back(values);
    }
    const Eigen::Vector3d& rotation = uncertainty.rotationDeg;
    return {{"about", "centroid of the tree, camera axes"},
            {"order", {"rotationX", "rotationY", "rotationZ", "translationX", "translationY", "depth"}},
            {"units", "rad, mm"},
            {"covariance", covariance},
            {"inPlaneStdMm", uncertainty.inPlaneMm},
            {"depthStdMm", uncertainty.depthMm},
            {"rotationStdDeg", {rotation.x(), rotation.y(), rotation.z()}},
            {"observed", uncertainty.observed}};
}

Json branchesJson(const core::RegistrationResult& result)
{
    Json branches = Json::array();
    for (const core::BranchResidual& branch : result.branches) {
        branches.push_back({{"branch", branch.branchId},
                            {"points", branch.pointCount},
                            {"medianPx", branch.medianPx},
                            {"p95Px", branch.p95Px},
                            {"agreement", branch.agreement}});
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

Json inputsJson(const core::RegistrationCase& registrationCase)
{
    Json inputs{{"centerline",
                 {{"path", registrationCase.centerlineFile.path}, {"sha256", registrationCase.centerlineFile.sha256}}},
                {"image", {{"path", registrationCase.imageFile.path}, {"sha256", registrationCase.imageFile.sha256}}},
                {"frame", registrationCase.frame}};
    if (registrationCase.angiogram && !registrationCase.angiogram->identity.sopInstanceUid.empty()) {
        inputs["image"]["sopInstanceUid"] = registrationCase.angiogram->identity.sopInstanceUid;
    }
    if (!registrationCase.targetFile.path.empty()) {
        inputs["targetCenterline"] = {{"path", registrationCase.targetFile.path},
                                      {"sha256", registrationCase.targetFile.sha256}};
    }
    return inputs;
}

Json optionsJson(const core::RegistrationCase& registrationCase)
{
    Json options = Json::object();
    for (const core::OptionField& field : core::optionFields()) {
        const double value = field.read(registrationCase.options);
        const auto choice = static_cast<std::size_t>(std::max(0.0, value));
        options[std::string(field.key)] =
            choice < field.choices.size() ? Json(std::string(field.choices[choice])) : Json(value);
    }
    options["auxiliaryBranches"] = registrationCase.auxiliaryBranchIds;
    options["excludedBranches"] = registrationCase.excludedBranchIds;
    return options;
}

}   // namespace

std::string resultJson(const core::RegistrationCase& registrationCase, const core::RegistrationResult& result)
{
    const Json json{
        {"format", "angiopose-result"},
        {"version", 1},
        {"notice", "Not for clinical use"},
        {"programVersion", ANGIOPOSE_VERSION},
        {"title", registrationCase.title},
        {"method", result.method},
        {"pose", {{"cameraFromPatient", rowsOf(result.cameraFromPatient)}}},
        {"metrics", metricsJson(result.metrics)},
        {"uncertainty", uncertaintyJson(result.uncertainty)},
        {"perBranch", branchesJson(result)},
        {"alternatives", alternativesJson(result)},
        {"trustworthy", result.trustworthy},
        {"warnings", result.warnings},
        {"stopReason", std::string(core::toText(result.stopReason))},
        {"iterations", result.iterations},
        {"timeMs",
         {{"target", result.time.targetMs},
          {"search", result.time.searchMs},
          {"solve", result.time.solveMs},
          {"total", result.time.totalMs}}},
        {"inputs", inputsJson(registrationCase)},
        {"options", optionsJson(registrationCase)},
    };
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

core::Status writeResult(const core::RegistrationCase& registrationCase, const core::RegistrationResult& result,
                         const std::string& path)
{
    return writeAtomically(path, resultJson(registrationCase, result) + "\n");
}

}   // namespace io
