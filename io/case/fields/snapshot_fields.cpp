#include "io/case/fields/snapshot_fields.h"

#include "io/case/fields/json_values.h"
#include "io/support/pose_matrix.h"

#include <cmath>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using core::PoseSnapshot;
using core::SnapshotKind;
using core::SnapshotMetrics;

StoredFields<SnapshotMetrics> metricsFields()
{
    return {valueField("medianPx", numberSchema(), &SnapshotMetrics::medianPx),
            valueField("medianMm", numberSchema(), &SnapshotMetrics::medianMm),
            valueField("p95Mm", numberSchema(), &SnapshotMetrics::p95Mm),
            valueField("coverage", numberSchema(0, 1), &SnapshotMetrics::coverage),
            valueField("trustworthy", flagSchema(), &SnapshotMetrics::isTrustworthy)};
}

bool isFinite(const SnapshotMetrics& metrics)
{
    return std::isfinite(metrics.medianPx) && std::isfinite(metrics.medianMm) && std::isfinite(metrics.p95Mm) &&
           std::isfinite(metrics.coverage);
}

StoredField<PoseSnapshot> metricsField()
{
    return {
        "metrics",
        about(objectSchema(propertiesOf(metricsFields())), "As evaluated on its frame when the snapshot was saved."),
        [](const Json& value, PoseSnapshot& snapshot, ReadContext& reading) {
            readFields(value, snapshot.metrics.emplace(), metricsFields(), reading);
        },
        [](const PoseSnapshot& snapshot, const fs::path& folder) {
            return snapshot.metrics && isFinite(*snapshot.metrics)   // JSON does not support NaN
                       ? writeFields(*snapshot.metrics, metricsFields(), folder)
                       : Json();
        }};
}

StoredField<PoseSnapshot> kindField()
{
    return {"kind", about(choiceSchema({"kept", "run"}), "Saved by a user, or result of a registration."),
            [](const Json& value, PoseSnapshot& snapshot, ReadContext&) {
                snapshot.kind = value == "run" ? SnapshotKind::Run : SnapshotKind::Saved;
            },
            [](const PoseSnapshot& snapshot, const fs::path&) {
                return Json(snapshot.kind == SnapshotKind::Run ? "run" : "kept");
            }};
}

StoredField<PoseSnapshot> poseField()
{
    return {"cameraFromPatient", schemaReference("matrix"),
            [](const Json& value, PoseSnapshot& snapshot, ReadContext& reading) {
                if (const auto pose = poseFromRows(value.get<MatrixRows>())) {
                    snapshot.cameraFromPatient = pose.value();
                } else {
                    reading.problems.push_back(pose.error().message);
                }
            },
            [](const PoseSnapshot& snapshot, const fs::path&) { return Json(rowsOf(snapshot.cameraFromPatient)); }};
}

StoredFields<PoseSnapshot> snapshotFields()
{
    return {kindField(),
            optionalField("name", textSchema(), &PoseSnapshot::name),
            optionalField("author", textSchema(), &PoseSnapshot::author),
            optionalField("note", textSchema(), &PoseSnapshot::note),
            optionalField("time", about(textSchema(), "ISO 8601, UTC."), &PoseSnapshot::time),
            optionalField("method", about(textSchema(), "Absent: found manually."), &PoseSnapshot::method),
            valueField("frame", integerSchema(0, 100000), &PoseSnapshot::frame),
            poseField(),
            metricsField(),
            optionalField("runMs", Json{{"type", "number"}, {"minimum", 0}}, &PoseSnapshot::runMs)};
}

Json snapshotsSchema()
{
    Json schema = listSchema(objectSchema(propertiesOf(snapshotFields()), {"cameraFromPatient"}));
    schema["maxItems"] = 10000;
    return about(schema, "Poses saved by the user or found by registrations, oldest first.");
}

void readSnapshots(const Json& list, core::View& view, ReadContext& reading)
{
    const StoredFields<PoseSnapshot> fields = snapshotFields();
    for (const Json& each : list) {
        ReadContext ofSnapshot;
        PoseSnapshot& snapshot = view.snapshots.emplace_back();
        readItem(each, snapshot, fields, ofSnapshot);
        for (const core::Message& problem : ofSnapshot.problems) {
            reading.problems.push_back(problem.about("snapshots: " + std::to_string(view.snapshots.size() - 1)));
        }
        snapshot.id = static_cast<int>(view.snapshots.size());
    }
}

}   // namespace

StoredField<core::View> snapshotsField()
{
    return {"snapshots", snapshotsSchema(), readSnapshots, [](const core::View& view, const fs::path& folder) {
                Json list;
                for (const PoseSnapshot& snapshot : view.snapshots) {
                    list.push_back(itemJson(snapshot, snapshotFields(), folder));
                }
                return list;
            }};
}

}   // namespace angiopose::io
