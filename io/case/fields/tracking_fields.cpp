#include "io/case/fields/tracking_fields.h"

#include "io/case/fields/deformation_fields.h"
#include "io/case/fields/file_fields.h"
#include "io/case/fields/json_values.h"
#include "io/case/fields/result_rows.h"

#include <memory>
#include <utility>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using core::TrackedFrame;
using core::TrackedRun;
using core::TrackedRunFrame;

constexpr int maxFrames = 100000;

StoredFields<TrackedFrame> trackedFields()
{
    return {
        poseMatrixField(&TrackedFrame::cameraFromPatient), measureField("score", &TrackedFrame::score),
        optionalField("searched", about(flagSchema(), "The pose was found by a search, not from the previous frame."),
                      &TrackedFrame::isFromSearch),
        valueField("trustworthy", flagSchema(), &TrackedFrame::isTrustworthy)};
}

StoredField<TrackedRunFrame> problemField()
{
    return {"messages", about(listSchema(Json{{"type", "object"}}), "Reason why nothing was traced."),
            [](const Json& value, TrackedRunFrame& frame, ReadContext&) {
                if (const core::Messages messages = parseMessages(value.dump()); !messages.empty()) {
                    frame.problem = messages.front();
                }
            },
            [](const TrackedRunFrame& frame, const fs::path&) {
                return frame.problem ? Json::parse(messagesJson({*frame.problem})) : Json();
            }};
}

/// Returns the field of the deformation of a frame that shows the vessels. Copies in other frames are not stored.
StoredField<TrackedRunFrame> deformationOfFrameField()
{
    const StoredFields<core::DeformableResult> fields = deformationFieldsWithoutPoints();
    Json schema = objectSchema(propertiesOf(fields), {"verdict", "cameraFromPatient", "viewPoses", "stopReason"});
    return {"deformable", about(std::move(schema), "Deformation of the vessels in addition to the pose; absent: none."),
            [fields](const Json& value, TrackedRunFrame& frame, ReadContext& reading) {
                core::DeformableResult deformed;
                readFields(value, deformed, fields, reading);
                frame.deformed = std::make_shared<const core::DeformableResult>(std::move(deformed));
            },
            [fields](const TrackedRunFrame& frame, const fs::path& folder) {
                return core::hasOwnDeformation(frame) ? writeFields(*frame.deformed, fields, folder) : Json();
            }};
}

StoredFields<TrackedRunFrame> frameFields()
{
    StoredFields<TrackedRunFrame> rows{valueField("frame", integerSchema(0, maxFrames), &TrackedRunFrame::frame)};
    for (const StoredField<TrackedFrame>& field : trackedFields()) {
        rows.push_back(memberField<TrackedRunFrame>(
            [](auto& frame) -> auto& { return frame.tracked; }, field));
    }
    rows.push_back(problemField());
    rows.push_back(optionalField(
        "bentAsInFrame",
        about(integerSchema(0, maxFrames),
              "Frame whose deformation is used because this frame does not show the vessels well enough."),
        &TrackedRunFrame::deformationSourceFrame));
    rows.push_back(deformationOfFrameField());
    return rows;
}

StoredField<TrackedRun> framesField()
{
    const StoredFields<TrackedRunFrame> fields = frameFields();
    Json item = objectSchema(propertiesOf(fields), {"frame", "cameraFromPatient", "trustworthy"});
    Json schema = listSchema(std::move(item));
    schema["maxItems"] = maxFrames;
    return {"frames", about(std::move(schema), "In frame order."),
            [fields](const Json& list, TrackedRun& run, ReadContext& reading) {
                std::vector<TrackedRunFrame> frames;
                ReadContext ofFrames;
                for (const Json& each : list) {
                    readItem(each, frames.emplace_back(), fields, ofFrames);
                }
                for (const core::Message& problem : ofFrames.problems) {
                    reading.problems.push_back(problem.about("followed"));
                }
                run.frames = std::make_shared<const std::vector<TrackedRunFrame>>(std::move(frames));
            },
            [fields](const TrackedRun& run, const fs::path& folder) {
                Json list = Json::array();
                for (const TrackedRunFrame& frame : core::framesOf(run)) {
                    list.push_back(itemJson(frame, fields, folder));
                }
                return list;
            }};
}

StoredField<TrackedRun> deformationsFileField()
{
    return {"bends",
            about(objectSchema({{"path", schemaReference("path")}, {"sha256", schemaReference("sha256")}}, {"path"}),
                  "NRRD with the motion of every point in every frame that has its own deformation."),
            [](const Json& value, TrackedRun& run, ReadContext&) { run.deformationsFile = fileFrom(value); },
            [](const TrackedRun& run, const fs::path& folder) { return fileJson(run.deformationsFile, folder); }};
}

}   // namespace

StoredField<core::View> trackingField()
{
    const StoredFields<TrackedRun> rows{
        valueField("fromFrame", about(integerSchema(0, maxFrames), "Frame whose pose was given."),
                   &TrackedRun::startFrame),
        deformationsFileField(), framesField()};
    Json schema = objectSchema(propertiesOf(rows), {"fromFrame", "frames"});
    schema["properties"]["savedWith"] =
        about(Json{{"type", "object"}, {"additionalProperties", textSchema()}}, "As in a result.");
    return {"followed",
            about(std::move(schema), "Result of tracking the vessels through the run; absent: not tracked."),
            [rows](const Json& value, core::View& view, ReadContext& reading) {
                readFields(value, view.followed, rows, reading);
            },
            [rows](const core::View& view, const fs::path& folder) {
                return view.followed.frames ? writeFields(view.followed, rows, folder) : Json();
            }};
}

}   // namespace angiopose::io
