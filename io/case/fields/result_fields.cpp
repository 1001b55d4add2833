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

/// Returns the field of a column vector, stored as a list, or of a matrix, stored as a list of its rows.
template <class Owner, int Rows, int Columns>
StoredField<Owner> measureFields(std::string key, Eigen::Matrix<double, Rows, Columns> Owner::*member)
{
    const auto place = [](auto& json, int row, int column) -> auto&
    {
        return Columns == 1 ? json.at(static_cast<std::size_t>(row))
                            : json.at(static_cast<std::size_t>(row)).at(static_cast<std::size_t>(column));
    };
    Json blank = Columns == 1 ? Json(std::vector<double>(Rows))
                              : Json(std::vector<std::vector<double>>(Rows, std::vector<double>(Columns)));
    return {std::move(key), listSchema(Columns == 1 ? measureSchema() : listSchema(measureSchema())),
            [member, place](const Json& value, Owner& owner, ReadContext&) {
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
    return {measureField("meanProjectionDistancePx", &DistanceMetrics::meanPx),
            measureField("medianProjectionDistancePx", &DistanceMetrics::medianPx),
            measureField("p75ProjectionDistancePx", &DistanceMetrics::p75Px),
            measureField("p95ProjectionDistancePx", &DistanceMetrics::p95Px),
            measureField("meanProjectionDistanceMm", &DistanceMetrics::meanMm),
            measureField("medianProjectionDistanceMm", &DistanceMetrics::medianMm),
            measureField("p75ProjectionDistanceMm", &DistanceMetrics::p75Mm),
            measureField("p95ProjectionDistanceMm", &DistanceMetrics::p95Mm),
            measureField("coverage", &DistanceMetrics::coverage),
            measureField("reverseDistancePx", &DistanceMetrics::reverseMeanPx),
            measureField("reverseDistanceMm", &DistanceMetrics::reverseMeanMm)};
}

/// Returns a constant field written for readers; ignored when read, because other versions may write another value.
StoredField<PoseUncertainty> constantTextField(std::string key, Json said)
{
    return {std::move(key), Json::object(), [](const Json&, PoseUncertainty&, ReadContext&) {},
            [said = std::move(said)](const PoseUncertainty&, const fs::path&) { return said; }};
}

StoredFields<PoseUncertainty> uncertaintyFields()
{
    return {constantTextField("order", {"rotationX", "rotationY", "rotationZ", "x", "y", "z"}),
            constantTextField("units", {"rad", "rad", "rad", "mm", "mm", "mm"}),
            constantTextField("frame", "camera axes about the centroid of the vessel tree"),
            measureFields("covariance", &PoseUncertainty::covariance),
            measureFields("imageCovariance", &PoseUncertainty::imageCovariance),
            measureFields("rotationSigmaDeg", &PoseUncertainty::rotationDeg),
            measureField("inPlaneSigmaMm", &PoseUncertainty::inPlaneMm),
            measureField("depthSigmaMm", &PoseUncertainty::depthMm),
            valueField("observed", listSchema(flagSchema()), &PoseUncertainty::observed),
            measureFields("weakestDirection", &PoseUncertainty::weakestDirection)};
}

StoredFields<CameraEvidence> cameraEvidenceFields()
{
    return {measureFields("error", &CameraEvidence::error), measureFields("sigma", &CameraEvidence::std),
            measureField("gain", &CameraEvidence::gain)};
}

/// Returns the field of the evidence about the camera, which is present only if the camera is uncertain.
StoredField<RegistrationResult> cameraEvidenceField()
{
    const StoredFields<CameraEvidence> fields = cameraEvidenceFields();
    Json schema{{"type", "object"}, {"properties", propertiesOf(fields)}};
    return {"camera",
            about(std::move(schema),
                  "Evidence of the images about the camera: error (log of the focal length, then the principal point "
                  "in px) with its sigma, and how much better it explains the images."),
            [fields](const Json& value, RegistrationResult& result, ReadContext& reading) {
                readFields(value, result.camera.emplace(), fields, reading);
            },
            [fields](const RegistrationResult& result, const fs::path& folder) {
                return result.camera ? writeFields(*result.camera, fields, folder) : Json();
            }};
}

StoredFields<BranchResidual> branchFields()
{
    return {valueField("branch", Json{{"type", "integer"}}, &BranchResidual::branchId),
            valueField("points", Json{{"type", "integer"}, {"minimum", 0}}, &BranchResidual::pointCount),
            measureField("medianPx", &BranchResidual::medianPx), measureField("p95Px", &BranchResidual::p95Px),
            measureField("agreement", &BranchResidual::agreement)};
}

StoredFields<UnopacifiedBranch> unopacifiedFields()
{
    return {valueField("branch", Json{{"type", "integer"}}, &UnopacifiedBranch::branchId),
            measureField("share", &UnopacifiedBranch::share)};
}

StoredFields<Hypothesis> hypothesisFields()
{
    return {poseMatrixField(&Hypothesis::cameraFromPatient), measureField("score", &Hypothesis::score)};
}

StoredFields<WirePath> wirePathFields()
{
    return {valueField("branches", listSchema(Json{{"type", "integer"}}), &WirePath::branchIds),
            measureFields("tip", &WirePath::tipInPatient),
            measureField("probability", &WirePath::probability),
            measureField("offAxisMm", &WirePath::offAxisMm),
            measureField("followedShare", &WirePath::followedShare),
            poseMatrixField(&WirePath::cameraFromPatient)};
}

StoredFields<StageTimes> timeFields()
{
    return {measureField("target", &StageTimes::targetMs), measureField("search", &StageTimes::searchMs),
            measureField("solve", &StageTimes::solveMs),   measureField("total", &StageTimes::totalMs),
            measureField("reading", &StageTimes::readMs),  measureField("tracing", &StageTimes::traceMs)};
}

StoredField<IterationReport> stageField()
{
    return {"stage", textSchema(),
            [](const Json& value, IterationReport& report, ReadContext&) {
                report.stage = persistentText(value.get<std::string>().substr(0, longestStageName));
            },
            [](const IterationReport& report, const fs::path&) { return Json(report.stage); }};
}

StoredFields<IterationReport> iterationFields()
{
    return {valueField("iteration", Json{{"type", "integer"}}, &IterationReport::iteration),
            stageField(),
            measureField("progress", &IterationReport::progress),
            measureField("scalePx", &IterationReport::scalePx),
            measureField("medianDistancePx", &IterationReport::medianDistancePx),
            measureField("stepMm", &IterationReport::stepMm),
            poseMatrixField(&IterationReport::cameraFromPatient),
            optionalField("view", Json{{"type", "integer"}, {"minimum", 0}}, &IterationReport::view)};
}

/// Returns the field of the initial pose, which is stored together with the resulting pose.
StoredField<RegistrationResult> startField()
{
    return {"initial", about(schemaReference("pose"), "Initial pose."),
            [](const Json& value, RegistrationResult& result, ReadContext& reading) {
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
            [](const Json& value, Provenance& provenance, ReadContext& reading) {
                readOptions(value.dump(), provenance.options, reading.problems);
            },
            [](const Provenance& provenance, const fs::path&) { return Json::parse(optionsJson(provenance.options)); }};
}

StoredFields<Provenance> provenanceFields()
{
    return {optionalField("author", textSchema(), &Provenance::author),
            optionalField("time", about(textSchema(), "ISO 8601, UTC."), &Provenance::time), runOptionsField(),
            optionalField("programVersion", textSchema(), &Provenance::programVersion)};
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
            valueField("method", textSchema(), &RegistrationResult::method),
            groupField<RegistrationResult>("pose", Json::object(),
                                           {poseMatrixField(&RegistrationResult::cameraFromPatient), startField()}),
            objectField("metrics", Json::object(), &RegistrationResult::metrics, distanceMetricsFields()),
            objectField("uncertainty", Json::object(), &RegistrationResult::uncertainty, uncertaintyFields()),
            cameraEvidenceField(),
            listField("perBranch", Json::object(), &RegistrationResult::branches, Json::object(), branchFields()),
            listField("unfilled",
                      about(Json::object(),
                            "Branches that appear unopacified in the image; the pose is based on the others."),
                      &RegistrationResult::unopacified, Json::object(), unopacifiedFields()),
            listField("alternatives", Json::object(), &RegistrationResult::alternatives, Json::object(),
                      hypothesisFields()),
            listField("ways",
                      about(Json::object(),
                            "Possible paths of a guidewire or catheter through the tree (method wire), the path of "
                            "the pose first: branches in order along the wire, and position of its tip (LPS mm)."),
                      &RegistrationResult::wirePaths, Json::object(), wirePathFields()),
            valueField("trustworthy", flagSchema(), &RegistrationResult::trustworthy),
            optionalField(
                "probabilityWithin2Mm",
                about(Json{{"type", "number"}, {"minimum", 0}, {"maximum", 1}},
                      "Probability that the overlay lies within 2 mm of the vessels, on average over the tree."),
                &RegistrationResult::probabilityWithin2Mm),
            messagesField(&RegistrationResult::warnings),
            stopReasonField(&RegistrationResult::stopReason),
            valueField("iterations", Json{{"type", "integer"}, {"minimum", 0}}, &RegistrationResult::iterations),
            objectField("timeMs", Json::object(), &RegistrationResult::time, timeFields()),
        };
        for (const StoredField<Provenance>& field : provenanceFields()) {
            rows.push_back(memberField<RegistrationResult>(
                [](auto& result) -> auto& { return result.provenance; }, field));
        }
        return rows;
    }();
    return fields;
}

StoredField<core::View> resultField()
{
    StoredFields<RegistrationResult> rows = resultFields();
    rows.push_back(deformationField());
    rows.push_back(memberField<RegistrationResult>(
        [](auto& result) -> auto& { return result.provenance; },
        optionalField("frame",
                      about(Json{{"type", "integer"}, {"minimum", 0}},
                            "Registered frame, counted from 0; absent: the displayed frame."),
                      &Provenance::frame)));
    rows.push_back(
        listField("history", Json::object(), &RegistrationResult::history, Json::object(), iterationFields()));
    Json schema = objectSchema(propertiesOf(rows),
                               {"method", "pose", "metrics", "uncertainty", "trustworthy", "messages", "stopReason"});
    schema["properties"]["savedWith"] =
        about(Json{{"type", "object"}, {"additionalProperties", textSchema()}},
              "Hashes of the data that the result was saved with. If one differs, the result is ignored.");
    return {"result",
            about(std::move(schema),
                  "Result of the registration that found the current pose; absent: the pose has another origin."),
            [rows](const Json& value, core::View& view, ReadContext& reading) {
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
