#include "io/case/fields/result_fields.h"

#include "io/case/fields/deformation_fields.h"
#include "io/case/fields/option_values.h"
#include "io/case/fields/result_rows.h"
#include "io/support/message_json.h"

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using core::BranchResidual;
using core::CameraEvidence;
using core::DistanceMetrics;
using core::Hypothesis;
using core::IterationReport;
using core::PoseUncertainty;
using core::Provenance;
using core::RegistrationResult;
using core::StageTimes;
using core::UnopacifiedBranch;
using core::WirePath;

constexpr std::size_t longestStageName = 40;

/// Field of a column vector, stored as a list, or of a matrix, stored as a list of its rows.
template <class Owner, int Rows, int Columns>
StoredField<Owner> storedMeasures(std::string key, Eigen::Matrix<double, Rows, Columns> Owner::*member)
{
    const auto place = [](auto& json, int row, int column) -> auto&
    {
        return Columns == 1 ? json.at(static_cast<std::size_t>(row))
                            : json.at(static_cast<std::size_t>(row)).at(static_cast<std::size_t>(column));
    };
    Json blank = Columns == 1 ? Json(std::vector<double>(Rows))
                              : Json(std::vector<std::vector<double>>(Rows, std::vector<double>(Columns)));
    return {std::move(key), listSchema(Columns == 1 ? measureSchema() : listSchema(measureSchema())),
            [member, place](const Json& value, Owner& owner, Reading&) {
                for (int i = 0; i < Rows * Columns; ++i) {
                    (owner.*member)(i / Columns, i % Columns) = measureFrom(place(value, i / Columns, i % Columns));
                }
            },
            [member, place, blank = std::move(blank)](const Owner& owner, const fs::path&) {
                Json json = blank;
                for (int i = 0; i < Rows * Columns; ++i) {
                    place(json, i / Columns, i % Columns) = (owner.*member)(i / Columns, i % Columns);
                }
                return json;
            }};
}

StoredFields<DistanceMetrics> distanceMetricsFields()
{
    return {storedMeasure("meanProjectionDistancePx", &DistanceMetrics::meanPx),
            storedMeasure("medianProjectionDistancePx", &DistanceMetrics::medianPx),
            storedMeasure("p75ProjectionDistancePx", &DistanceMetrics::p75Px),
            storedMeasure("p95ProjectionDistancePx", &DistanceMetrics::p95Px),
            storedMeasure("meanProjectionDistanceMm", &DistanceMetrics::meanMm),
            storedMeasure("medianProjectionDistanceMm", &DistanceMetrics::medianMm),
            storedMeasure("p75ProjectionDistanceMm", &DistanceMetrics::p75Mm),
            storedMeasure("p95ProjectionDistanceMm", &DistanceMetrics::p95Mm),
            storedMeasure("coverage", &DistanceMetrics::coverage),
            storedMeasure("reverseDistancePx", &DistanceMetrics::reverseMeanPx),
            storedMeasure("reverseDistanceMm", &DistanceMetrics::reverseMeanMm)};
}

/// Constant that is written for human readers; ignored when read, because other versions may write another value.
StoredField<PoseUncertainty> saidField(std::string key, Json said)
{
    return {std::move(key), Json::object(), [](const Json&, PoseUncertainty&, Reading&) {},
            [said = std::move(said)](const PoseUncertainty&, const fs::path&) { return said; }};
}

StoredFields<PoseUncertainty> uncertaintyFields()
{
    return {saidField("order", {"rotationX", "rotationY", "rotationZ", "x", "y", "z"}),
            saidField("units", {"rad", "rad", "rad", "mm", "mm", "mm"}),
            saidField("frame", "camera axes about the centroid of the vessel tree"),
            storedMeasures("covariance", &PoseUncertainty::covariance),
            storedMeasures("imageCovariance", &PoseUncertainty::imageCovariance),
            storedMeasures("rotationSigmaDeg", &PoseUncertainty::rotationDeg),
            storedMeasure("inPlaneSigmaMm", &PoseUncertainty::inPlaneMm),
            storedMeasure("depthSigmaMm", &PoseUncertainty::depthMm),
            storedValue("observed", listSchema(flagSchema()), &PoseUncertainty::observed),
            storedMeasures("weakestDirection", &PoseUncertainty::weakestDirection)};
}

StoredFields<CameraEvidence> cameraEvidenceFields()
{
    return {storedMeasures("error", &CameraEvidence::error), storedMeasures("sigma", &CameraEvidence::std),
            storedMeasure("gain", &CameraEvidence::gain)};
}

/// Evidence about the camera; present only if the camera is uncertain.
StoredField<RegistrationResult> cameraEvidenceField()
{
    const StoredFields<CameraEvidence> fields = cameraEvidenceFields();
    Json schema{{"type", "object"}, {"properties", propertiesOf(fields)}};
    return {"camera",
            about(std::move(schema),
                  "Evidence of the images about the camera: error (log of the focal length, then the principal point "
                  "in px) with its sigma, and how much better it explains the images."),
            [fields](const Json& value, RegistrationResult& result, Reading& reading) {
                readFields(value, result.camera.emplace(), fields, reading);
            },
            [fields](const RegistrationResult& result, const fs::path& folder) {
                return result.camera ? writeFields(*result.camera, fields, folder) : Json();
            }};
}

StoredFields<BranchResidual> branchFields()
{
    return {storedValue("branch", Json{{"type", "integer"}}, &BranchResidual::branchId),
            storedValue("points", Json{{"type", "integer"}, {"minimum", 0}}, &BranchResidual::pointCount),
            storedMeasure("medianPx", &BranchResidual::medianPx), storedMeasure("p95Px", &BranchResidual::p95Px),
            storedMeasure("agreement", &BranchResidual::agreement)};
}

StoredFields<UnopacifiedBranch> unopacifiedFields()
{
    return {storedValue("branch", Json{{"type", "integer"}}, &UnopacifiedBranch::branchId),
            storedMeasure("share", &UnopacifiedBranch::share)};
}

StoredFields<Hypothesis> hypothesisFields()
{
    return {storedPose(&Hypothesis::cameraFromPatient), storedMeasure("score", &Hypothesis::score)};
}

StoredFields<WirePath> wirePathFields()
{
    return {storedValue("branches", listSchema(Json{{"type", "integer"}}), &WirePath::branchIds),
            storedMeasures("tip", &WirePath::tipInPatient),
            storedMeasure("probability", &WirePath::probability),
            storedMeasure("offAxisMm", &WirePath::offAxisMm),
            storedMeasure("followedShare", &WirePath::followedShare),
            storedPose(&WirePath::cameraFromPatient)};
}

StoredFields<StageTimes> timeFields()
{
    return {storedMeasure("target", &StageTimes::targetMs), storedMeasure("search", &StageTimes::searchMs),
            storedMeasure("solve", &StageTimes::solveMs),   storedMeasure("total", &StageTimes::totalMs),
            storedMeasure("reading", &StageTimes::readMs),  storedMeasure("tracing", &StageTimes::traceMs)};
}

StoredField<IterationReport> stageField()
{
    return {"stage", textSchema(),
            [](const Json& value, IterationReport& report, Reading&) {
                report.stage = lasting(value.get<std::string>().substr(0, longestStageName));
            },
            [](const IterationReport& report, const fs::path&) { return Json(report.stage); }};
}

StoredFields<IterationReport> iterationFields()
{
    return {storedValue("iteration", Json{{"type", "integer"}}, &IterationReport::iteration),
            stageField(),
            storedMeasure("progress", &IterationReport::progress),
            storedMeasure("scalePx", &IterationReport::scalePx),
            storedMeasure("medianDistancePx", &IterationReport::medianDistancePx),
            storedMeasure("stepMm", &IterationReport::stepMm),
            storedPose(&IterationReport::cameraFromPatient),
            storedIfSet("view", Json{{"type", "integer"}, {"minimum", 0}}, &IterationReport::view)};
}

/// Initial pose, stored together with the resulting pose.
StoredField<RegistrationResult> startField()
{
    return {"initial", about(definedAs("pose"), "Initial pose."),
            [](const Json& value, RegistrationResult& result, Reading& reading) {
                if (const auto pose = poseFromRows(value.at("cameraFromPatient").get<MatrixRows>())) {
                    result.provenance.start = pose.value();
                } else {
                    reading.problems.push_back(pose.error().message.about("result"));
                }
            },
            [](const RegistrationResult& result, const fs::path&) {
                const auto& start = result.provenance.start;
                return start ? Json{{"cameraFromPatient", rowsOf(*start)}} : Json();
            }};
}

StoredField<Provenance> runOptionsField()
{
    return {"options", about(Json{{"type", "object"}}, "Options of the registration."),
            [](const Json& value, Provenance& provenance, Reading& reading) {
                readOptions(value.dump(), provenance.options, reading.problems);
            },
            [](const Provenance& provenance, const fs::path&) { return Json::parse(optionsJson(provenance.options)); }};
}

StoredFields<Provenance> provenanceFields()
{
    return {storedIfSet("author", textSchema(), &Provenance::author),
            storedIfSet("time", about(textSchema(), "ISO 8601, UTC."), &Provenance::time), runOptionsField(),
            storedIfSet("programVersion", textSchema(), &Provenance::programVersion)};
}

bool isAt(const core::RigidTransform& pose, const RegistrationResult& result)
{
    return pose.matrix() == result.cameraFromPatient.matrix();
}

}   // namespace

const StoredFields<RegistrationResult>& resultFields()
{
    static const StoredFields<RegistrationResult> fields = [] {
        StoredFields<RegistrationResult> rows{
            storedValue("method", textSchema(), &RegistrationResult::method),
            storedGroup<RegistrationResult>("pose", Json::object(),
                                            {storedPose(&RegistrationResult::cameraFromPatient), startField()}),
            storedPart("metrics", Json::object(), &RegistrationResult::metrics, distanceMetricsFields()),
            storedPart("uncertainty", Json::object(), &RegistrationResult::uncertainty, uncertaintyFields()),
            cameraEvidenceField(),
            storedList("perBranch", Json::object(), &RegistrationResult::branches, Json::object(), branchFields()),
            storedList("unfilled",
                       about(Json::object(),
                             "Branches that appear unopacified in the image; the pose is based on the others."),
                       &RegistrationResult::unopacified, Json::object(), unopacifiedFields()),
            storedList("alternatives", Json::object(), &RegistrationResult::alternatives, Json::object(),
                       hypothesisFields()),
            storedList("ways",
                       about(Json::object(),
                             "Possible paths of a guidewire or catheter through the tree (method wire), the path of "
                             "the pose first: branches in order along the wire, and position of its tip (LPS mm)."),
                       &RegistrationResult::wirePaths, Json::object(), wirePathFields()),
            storedValue("trustworthy", flagSchema(), &RegistrationResult::trustworthy),
            storedIfSet(
                "probabilityWithin2Mm",
                about(Json{{"type", "number"}, {"minimum", 0}, {"maximum", 1}},
                      "Probability that the overlay lies within 2 mm of the vessels, on average over the tree."),
                &RegistrationResult::probabilityWithin2Mm),
            storedMessages(&RegistrationResult::warnings),
            storedReason(&RegistrationResult::stopReason),
            storedValue("iterations", Json{{"type", "integer"}, {"minimum", 0}}, &RegistrationResult::iterations),
            storedPart("timeMs", Json::object(), &RegistrationResult::time, timeFields()),
        };
        for (const StoredField<Provenance>& field : provenanceFields()) {
            rows.push_back(storedThrough<RegistrationResult>(
                [](auto& result) -> auto& { return result.provenance; }, field));
        }
        return rows;
    }();
    return fields;
}

StoredField<core::View> resultField()
{
    StoredFields<RegistrationResult> rows = resultFields();
    rows.push_back(deformedField());
    rows.push_back(storedThrough<RegistrationResult>(
        [](auto& result) -> auto& { return result.provenance; },
        storedIfSet("frame",
                    about(Json{{"type", "integer"}, {"minimum", 0}},
                          "Registered frame, counted from 0; absent: the displayed frame."),
                    &Provenance::frame)));
    rows.push_back(
        storedList("history", Json::object(), &RegistrationResult::history, Json::object(), iterationFields()));
    Json schema = objectSchema(propertiesOf(rows),
                               {"method", "pose", "metrics", "uncertainty", "trustworthy", "messages", "stopReason"});
    schema["properties"]["savedWith"] =
        about(Json{{"type", "object"}, {"additionalProperties", textSchema()}},
              "Hashes of the data that the result was saved with. If one differs, the result is ignored.");
    return {"result",
            about(std::move(schema),
                  "Result of the registration that found the current pose; absent: the pose has another origin."),
            [rows](const Json& value, core::View& view, Reading& reading) {
                RegistrationResult result;
                readFields(value, result, rows, reading);
                if (isAt(view.cameraFromPatient, result)) {
                    view.result = std::move(result);
                }
            },
            [rows](const core::View& view, const fs::path& folder) {
                return view.result ? writeFields(*view.result, rows, folder) : Json();
            }};
}

}   // namespace angiopose::io
