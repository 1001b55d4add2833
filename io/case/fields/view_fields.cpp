#include "io/case/fields/view_fields.h"

#include "io/case/fields/file_fields.h"
#include "io/case/fields/geometry_fields.h"
#include "io/case/fields/json_values.h"
#include "io/case/fields/mark_fields.h"
#include "io/case/fields/measurement_fields.h"
#include "io/case/fields/result_fields.h"
#include "io/case/fields/subtraction_fields.h"
#include "io/case/fields/tracking_fields.h"
#include "io/messages/messages.h"
#include "io/support/pose_matrix.h"

#include <cmath>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using core::GivenTarget;
using core::PoseSnapshot;
using core::SnapshotKind;
using core::SnapshotMetrics;
using core::TraceOptions;
using core::View;

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

StoredField<PoseSnapshot> snapshotKindField()
{
    return {"kind", about(choiceSchema({"kept", "run"}), "Saved by a user, or result of a registration."),
            [](const Json& value, PoseSnapshot& snapshot, ReadContext&) {
                snapshot.kind = value == "run" ? SnapshotKind::Run : SnapshotKind::Saved;
            },
            [](const PoseSnapshot& snapshot, const fs::path&) {
                return Json(snapshot.kind == SnapshotKind::Run ? "run" : "kept");
            }};
}

StoredField<PoseSnapshot> snapshotPoseField()
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
    return {snapshotKindField(),
            optionalField("name", textSchema(), &PoseSnapshot::name),
            optionalField("author", textSchema(), &PoseSnapshot::author),
            optionalField("note", textSchema(), &PoseSnapshot::note),
            optionalField("time", about(textSchema(), "ISO 8601, UTC."), &PoseSnapshot::time),
            optionalField("method", about(textSchema(), "Absent: found manually."), &PoseSnapshot::method),
            valueField("frame", integerSchema(0, 100000), &PoseSnapshot::frame),
            snapshotPoseField(),
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

/// Returns the field of the snapshots, which are numbered from 1.
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

/// Returns the field of the image file, with the SOP instance UID of the image.
StoredField<View> imageField()
{
    return {"image", schemaReference("input"),
            [](const Json& value, View& view, ReadContext& reading) {
                view.imageFile = fileFrom(value);
                reading.view.sopInstanceUid = value.value("dicom", Json::object()).value("sopInstanceUid", "");
            },
            [](const View& view, const fs::path& folder) {
                Json json = fileJson(view.imageFile, folder);
                if (view.angiogram && !view.angiogram->identity.sopInstanceUid.empty()) {
                    const core::StudyIdentity& identity = view.angiogram->identity;
                    json["dicom"] = {{"studyInstanceUid", identity.studyUid},
                                     {"seriesInstanceUid", identity.seriesUid},
                                     {"sopInstanceUid", identity.sopInstanceUid}};
                }
                return json;
            }};
}

StoredField<View> frameField()
{
    return {"frame", about(integerSchema(0, 100000), "Counted from 0; absent: the peak-opacification frame."),
            [](const Json& value, View& view, ReadContext& reading) {
                view.frame = value.get<int>();
                reading.view.hasFrame = true;
            },
            [](const View& view, const fs::path&) { return Json(view.frame); }};
}

/// Returns the fields of the registration target; curves edited in the GUI are flagged and stored with their frame.
StoredFields<GivenTarget> targetFields()
{
    const StoredField<GivenTarget> origin{
        "origin",
        about(choiceSchema({"given", "edited"}),
              "edited: curves of one frame, edited and saved in the window. Absent: given."),
        [](const Json& value, GivenTarget& target, ReadContext&) {
            if (value == "edited") {
                target.editedFrame = 0;
            }
        },
        [](const GivenTarget& target, const fs::path&) { return target.editedFrame ? Json("edited") : Json(); }};
    const StoredField<GivenTarget> frame{
        "frame", about(integerSchema(0, 100000), "Frame of edited curves; they replace tracing for this frame only."),
        [](const Json& value, GivenTarget& target, ReadContext&) {
            if (target.editedFrame) {
                target.editedFrame = value.get<int>();
            }
        },
        [](const GivenTarget& target, const fs::path&) { return Json(target.editedFrame); }};
    const auto isEdited = [](const GivenTarget& target) { return target.editedFrame.has_value(); };
    const StoredField<GivenTarget> devices{
        "deviceCurves",
        about(schemaReference("branchIds"),
              "Edited curves that are catheters or guidewires, not vessels; the method wire uses them."),
        [](const Json& value, GivenTarget&, ReadContext& reading) {
            reading.view.deviceCurveIds = value.get<std::vector<int>>();
        },
        [](const GivenTarget& target, const fs::path&) {
            return target.devices ? Json(core::curveIds(*target.devices)) : Json();
        }};
    return {
        origin, frame, writeFieldIf(isEdited, devices),
        writeFieldIf(isEdited, valueField("acceptedCurves",
                                          about(schemaReference("branchIds"),
                                                "Edited curves that are vessels although they look like a catheter."),
                                          &GivenTarget::acceptedCurveIds))};
}

StoredField<View> targetField()
{
    Json schema = objectSchema({{"path", schemaReference("path")}, {"sha256", schemaReference("sha256")}}, {"path"});
    schema["properties"].update(propertiesOf(targetFields()));
    return {"centerline", about(std::move(schema), "CSV or mask that replaces tracing."),
            [](const Json& value, View& view, ReadContext& reading) {
                view.target.file = fileFrom(value);
                readFields(value, view.target, targetFields(), reading);
                if (view.target.editedFrame && !value.contains("frame")) {
                    view.target.editedFrame = view.frame;
                }
            },
            [](const View& view, const fs::path& folder) {
                Json json = fileJson(view.target.file, folder);
                if (!json.is_null()) {
                    json.update(writeFields(view.target, targetFields(), folder));
                }
                return json;
            }};
}

StoredField<View> traceField()
{
    StoredField<View> field = objectField("trace", Json::object(), &View::traceOptions, traceOptionFields());
    field.read = [read = field.read](const Json& value, View& view, ReadContext& reading) {
        read(value, view, reading);
        const double widest = view.traceOptions.maxVesselRadiusPx;
        if (widest != 0.0 && widest < view.traceOptions.minVesselRadiusPx) {
            reading.problems.push_back(messages::caseRadiiSwapped().about("angiogram.trace"));
        }
    };
    return field;
}

/// Reads the pose at `pose.<key>`; returns nullopt if the pose is invalid.
std::optional<core::RigidTransform> poseFrom(const Json& value, const std::string& key, ReadContext& reading)
{
    const auto pose = poseFromRows(value.at("cameraFromPatient").get<MatrixRows>());
    if (!pose) {
        reading.problems.push_back(pose.error().message.about("pose." + key));
        return std::nullopt;
    }
    return pose.value();
}

Json poseJson(const core::RigidTransform& pose)
{
    return {{"cameraFromPatient", rowsOf(pose)}};
}

StoredField<View> initialPoseField()
{
    return {"initial",
            about(schemaReference("pose"), "Absent: from the angles, with the tree's centroid at the isocenter."),
            [](const Json& value, View& view, ReadContext& reading) {
                view.initialCameraFromPatient = poseFrom(value, "initial", reading);
            },
            [](const View& view, const fs::path&) {
                return view.initialCameraFromPatient ? poseJson(*view.initialCameraFromPatient) : Json();
            }};
}

StoredField<View> currentPoseField()
{
    return {"current", schemaReference("pose"),
            [](const Json& value, View& view, ReadContext& reading) {
                if (const auto pose = poseFrom(value, "current", reading)) {
                    view.cameraFromPatient = *pose;
                    reading.view.hasCurrentPose = true;
                }
            },
            [](const View& view, const fs::path&) { return poseJson(view.cameraFromPatient); }};
}

StoredField<View> landmarksField()
{
    using core::Landmark;
    const Json schema{
        {"description",
         "Corresponding points on the vessels and in the image, from which the initial pose can be computed."},
        {"maxItems", 10000}};
    return listField(
        "landmarks", schema, &View::landmarks, objectSchema({}, {"pointInPatientMm", "pixel"}),
        StoredFields<Landmark>{valueField("pointInPatientMm", schemaReference("point"), &Landmark::pointInPatient),
                               valueField("pixel", schemaReference("pair"), &Landmark::pixel),
                               optionalField("name", textSchema(), &Landmark::name)});
}

}   // namespace

const StoredFields<TraceOptions>& traceOptionFields()
{
    static const StoredFields<TraceOptions> fields{
        valueField("minVesselRadiusPx", numberSchema(0.1, 1000), &TraceOptions::minVesselRadiusPx),
        optionalField("maxVesselRadiusPx",
                      about(numberSchema(0.1, 1000), "Absent: from pixel spacing and magnification, at least 8."),
                      &TraceOptions::maxVesselRadiusPx),
        valueField("minBranchLengthPx", integerSchema(0, 100000), &TraceOptions::minBranchLengthPx),
        valueField("minComponentLengthPx", integerSchema(0, 100000), &TraceOptions::minComponentLengthPx),
        valueField("sensitivity", numberSchema(0.01, 100), &TraceOptions::sensitivity)};
    return fields;
}

const StoredFields<View>& viewFields()
{
    static const StoredFields<View> fields{
        groupField<View>(
            "angiogram", objectSchema({}, {"image"}),
            {optionalField("name", about(textSchema(), "Name of this view, given by the user."), &View::name),
             imageField(),

             optionalField("samePatient", about(flagSchema(), "A user confirmed it, whatever the headers say."),
                           &View::isSamePatient),
             frameField(), targetField(), subtractionField(), traceField(),
             optionalField("typedMmPerPx",
                           about(numberSchema(1e-6, 1000), "Pixel size in the patient, entered by the user."),
                           &View::enteredMmPerPx)}),
        objectField("geometry", Json::object(), &View::geometry, geometryFields()),
        groupField<View>("pose", Json::object(), {initialPoseField(), currentPoseField(), landmarksField()}),
        measurementsField(),
        observationsField(),
        annotationsField(),
        resultField(),
        trackingField(),
        snapshotsField(),
    };
    return fields;
}

}   // namespace angiopose::io
