#include "io/case/fields/subtraction_fields.h"

#include "io/case/fields/json_values.h"

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using core::MaskInterval;
using core::RunProcessing;
using core::View;

SubtractionOverrides& keysOf(ReadContext& reading)
{
    return *reading.view.subtraction;
}

StoredField<RunProcessing> compositeField()
{
    return {
        "composite",
        about(choiceSchema({"none", "minimum"}), "minimum: every frame is the peak-opacification image of the run."),
        [](const Json& value, RunProcessing& processing, ReadContext&) { processing.isComposite = value == "minimum"; },
        [](const RunProcessing& processing, const fs::path&) {
            return Json(processing.isComposite ? "minimum" : "none");
        }};
}

StoredField<RunProcessing> maskFramesField()
{
    return {
        "maskFrames",
        about(listSchema(integerSchema(0, 100000)), "Frames to average, counted from 0; empty: chosen automatically."),
        [](const Json& value, RunProcessing&, ReadContext& reading) {
            keysOf(reading).maskFrames = value.get<std::vector<int>>();
        },
        [](const RunProcessing& processing, const fs::path&) { return Json(processing.plan.maskFrames); }};
}

StoredField<RunProcessing> intervalField()
{
    static const StoredFields<MaskInterval> fields{
        valueField("offset", integerSchema(-100000, 100000), &MaskInterval::offset),
        optionalField("reversedFrom", integerSchema(0, 100000), &MaskInterval::reversedFrom)};
    return {"interval",
            about(objectSchema(propertiesOf(fields)),
                  "One mask per frame instead of averaged masks: offset frames before it (TID); with reversedFrom, "
                  "masks go backward from that frame (REV_TID)."),
            [](const Json& value, RunProcessing&, ReadContext& reading) {
                readFields(value, keysOf(reading).interval.emplace(), fields, reading);
            },
            [](const RunProcessing& processing, const fs::path& folder) {
                return processing.plan.interval ? writeFields(*processing.plan.interval, fields, folder) : Json();
            }};
}

StoredField<RunProcessing> maskShiftField()
{
    return {"maskShiftPx",
            about(anyOfSchema(schemaReference("pair"), choiceSchema({"automatic"})),
                  "Right, down, for every frame; automatic: determined for each frame."),
            [](const Json& value, RunProcessing&, ReadContext& reading) {
                keysOf(reading).isShiftAutomatic = value.is_string();
                if (value.is_array()) {
                    keysOf(reading).maskShiftPx = value.get<Eigen::Vector2d>();
                }
            },
            [](const RunProcessing& processing, const fs::path&) {
                return processing.plan.maskShiftPx ? Json(*processing.plan.maskShiftPx) : Json("automatic");
            }};
}

StoredField<RunProcessing> relationField()
{
    using core::PixelRelation;
    return {"pixelRelation", choiceSchema({"linear", "logarithmic"}),
            [](const Json& value, RunProcessing&, ReadContext& reading) {
                keysOf(reading).relation = value == "logarithmic" ? PixelRelation::Logarithmic : PixelRelation::Linear;
            },
            [](const RunProcessing& processing, const fs::path&) {
                return Json(processing.plan.relation == PixelRelation::Linear ? "linear" : "logarithmic");
            }};
}

StoredField<RunProcessing> polarityField()
{
    using core::Polarity;
    return {"vessels", about(choiceSchema({"dark", "bright"}), "Absent: as given by the image."),
            [](const Json& value, RunProcessing& processing, ReadContext&) {
                processing.polarity = value == "bright" ? Polarity::VesselsBright : Polarity::VesselsDark;
            },
            [](const RunProcessing& processing, const fs::path&) {
                return processing.polarity ? Json(processing.polarity == Polarity::VesselsBright ? "bright" : "dark")
                                           : Json();
            }};
}

StoredFields<RunProcessing> treatmentFields()
{
    return {valueField("on", about(flagSchema(), "Whether mask frames are subtracted; absent: yes."),
                       &RunProcessing::isSubtracted),
            compositeField(),
            maskFramesField(),
            intervalField(),
            maskShiftField(),
            relationField(),
            polarityField()};
}

}   // namespace

StoredField<View> subtractionField()
{
    const Json schema{{"description",
                       "Processing of the stored frames into the run that is displayed and traced. Absent keys: as in "
                       "the image's header."}};
    StoredField<View> field = objectField("subtraction", schema, &View::processing, treatmentFields());
    field.read = [read = field.read](const Json& value, View& view, ReadContext& reading) {
        reading.view.subtraction.emplace();
        view.processing.isSubtracted = true;
        read(value, view, reading);
    };
    return writeFieldIf([](const View& view) { return view.processing != RunProcessing{.plan = view.headerPlan}; },
                        std::move(field));
}

}   // namespace angiopose::io
