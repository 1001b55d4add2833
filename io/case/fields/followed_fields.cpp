#include "io/case/fields/followed_fields.h"

#include "io/case/fields/deformation_fields.h"
#include "io/case/fields/file_fields.h"
#include "io/case/fields/json_values.h"
#include "io/case/fields/result_rows.h"

#include <memory>
#include <utility>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using core::FollowedFrame;
using core::FollowedRun;
using core::TrackedFrame;

constexpr int maxFrames = 100000;

StoredFields<TrackedFrame> trackedFields()
{
    return {storedPose(&TrackedFrame::cameraFromPatient), storedMeasure("score", &TrackedFrame::score),
            storedIfSet("searched", about(flagSchema(), "The pose was found by a search, not from the previous frame."),
                        &TrackedFrame::searched),
            storedValue("trustworthy", flagSchema(), &TrackedFrame::isTrustworthy)};
}

StoredField<FollowedFrame> problemField()
{
    return {"messages", about(listSchema(Json{{"type", "object"}}), "Reason why nothing was traced."),
            [](const Json& value, FollowedFrame& frame, Reading&) {
                if (const core::Messages messages = messagesFrom(value.dump()); !messages.empty()) {
                    frame.problem = messages.front();
                }
            },
            [](const FollowedFrame& frame, const fs::path&) {
                return frame.problem ? Json::parse(messagesJson({*frame.problem})) : Json();
            }};
}

/// Deformation of a frame that shows the vessels. Frames that copy a deformation are not stored; reading restores them.
StoredField<FollowedFrame> deformationOfFrameField()
{
    const StoredFields<core::DeformableResult> fields = deformedFieldsWithoutPoints();
    Json schema = objectSchema(propertiesOf(fields), {"verdict", "cameraFromPatient", "viewPoses", "stopReason"});
    return {"deformable", about(std::move(schema), "Deformation of the vessels in addition to the pose; absent: none."),
            [fields](const Json& value, FollowedFrame& frame, Reading& reading) {
                core::DeformableResult deformed;
                readFields(value, deformed, fields, reading);
                frame.deformed = std::make_shared<const core::DeformableResult>(std::move(deformed));
            },
            [fields](const FollowedFrame& frame, const fs::path& folder) {
                return core::isDeformedByItself(frame) ? writeFields(*frame.deformed, fields, folder) : Json();
            }};
}

StoredFields<FollowedFrame> frameFields()
{
    StoredFields<FollowedFrame> rows{storedValue("frame", integerSchema(0, maxFrames), &FollowedFrame::frame)};
    for (const StoredField<TrackedFrame>& field : trackedFields()) {
        rows.push_back(storedThrough<FollowedFrame>(
            [](auto& frame) -> auto& { return frame.tracked; }, field));
    }
    rows.push_back(problemField());
    rows.push_back(
        storedIfSet("bentAsInFrame",
                    about(integerSchema(0, maxFrames),
                          "Frame whose deformation is used because this frame does not show the vessels well enough."),
                    &FollowedFrame::deformedAsInFrame));
    rows.push_back(deformationOfFrameField());
    return rows;
}

StoredField<FollowedRun> framesField()
{
    const StoredFields<FollowedFrame> fields = frameFields();
    Json item = objectSchema(propertiesOf(fields), {"frame", "cameraFromPatient", "trustworthy"});
    Json schema = listSchema(std::move(item));
    schema["maxItems"] = maxFrames;
    return {"frames", about(std::move(schema), "In frame order."),
            [fields](const Json& list, FollowedRun& run, Reading& reading) {
                std::vector<FollowedFrame> frames;
                Reading ofFrames;
                for (const Json& each : list) {
                    readItem(each, frames.emplace_back(), fields, ofFrames);
                }
                for (const core::Message& problem : ofFrames.problems) {
                    reading.problems.push_back(problem.about("followed"));
                }
                run.frames = std::make_shared<const std::vector<FollowedFrame>>(std::move(frames));
            },
            [fields](const FollowedRun& run, const fs::path& folder) {
                Json list = Json::array();
                for (const FollowedFrame& frame : core::framesOf(run)) {
                    list.push_back(itemJson(frame, fields, folder));
                }
                return list;
            }};
}

StoredField<FollowedRun> deformationsFileField()
{
    return {"bends",
            about(objectSchema({{"path", definedAs("path")}, {"sha256", definedAs("sha256")}}, {"path"}),
                  "NRRD with the motion of every point in every frame that has its own deformation."),
            [](const Json& value, FollowedRun& run, Reading&) { run.deformationsFile = fileFrom(value); },
            [](const FollowedRun& run, const fs::path& folder) { return fileJson(run.deformationsFile, folder); }};
}

}   // namespace

StoredField<core::View> followedField()
{
    const StoredFields<FollowedRun> rows{
        storedValue("fromFrame", about(integerSchema(0, maxFrames), "Frame whose pose was given."),
                    &FollowedRun::fromFrame),
        deformationsFileField(), framesField()};
    Json schema = objectSchema(propertiesOf(rows), {"fromFrame", "frames"});
    schema["properties"]["savedWith"] =
        about(Json{{"type", "object"}, {"additionalProperties", textSchema()}}, "As in a result.");
    return {"followed",
            about(std::move(schema), "Result of tracking the vessels through the run; absent: not tracked."),
            [rows](const Json& value, core::View& view, Reading& reading) {
                readFields(value, view.followed, rows, reading);
            },
            [rows](const core::View& view, const fs::path& folder) {
                return view.followed.frames ? writeFields(view.followed, rows, folder) : Json();
            }};
}

}   // namespace angiopose::io
