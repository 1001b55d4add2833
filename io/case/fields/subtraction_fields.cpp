#include "io/case/fields/subtraction_fields.h"

#include "io/case/fields/json_values.h"

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using core::MaskInterval;
using core::RunTreatment;
using core::View;

SubtractionKeys& keysOf(Reading& reading)
{
    return *reading.view.subtraction;
}

StoredField<RunTreatment> compositeField()
{
    return {
        "composite",
        about(choiceSchema({"none", "minimum"}), "minimum: every frame is the peak-opacification image of the run."),
        [](const Json& value, RunTreatment& treatment, Reading&) { treatment.isComposite = value == "minimum"; },
        [](const RunTreatment& treatment, const fs::path&) {
            return Json(treatment.isComposite ? "minimum" : "none");
        }};
}

StoredField<RunTreatment> maskFramesField()
{
    return {
        "maskFrames",
        about(listSchema(integerSchema(0, 100000)), "Frames to average, counted from 0; empty: chosen automatically."),
        [](const Json& value, RunTreatment&, Reading& reading) {
            keysOf(reading).maskFrames = value.get<std::vector<int>>();
        },
        [](const RunTreatment& treatment, const fs::path&) { return Json(treatment.plan.maskFrames); }};
}

StoredField<RunTreatment> intervalField()
{
    static const StoredFields<MaskInterval> fields{
        storedValue("offset", integerSchema(-100000, 100000), &MaskInterval::offset),
        storedIfSet("reversedFrom", integerSchema(0, 100000), &MaskInterval::reversedFrom)};
    return {"interval",
            about(objectSchema(propertiesOf(fields)),
                  "One mask per frame instead of averaged masks: offset frames before it (TID); with reversedFrom, "
                  "masks go backward from that frame (REV_TID)."),
            [](const Json& value, RunTreatment&, Reading& reading) {
                readFields(value, keysOf(reading).interval.emplace(), fields, reading);
            },
            [](const RunTreatment& treatment, const fs::path& folder) {
                return treatment.plan.interval ? writeFields(*treatment.plan.interval, fields, folder) : Json();
            }};
}

StoredField<RunTreatment> maskShiftField()
{
    return {"maskShiftPx",
            about(anyOfSchema(definedAs("pair"), choiceSchema({"automatic"})),
                  "Right, down, for every frame; automatic: determined for each frame."),
            [](const Json& value, RunTreatment&, Reading& reading) {
                keysOf(reading).isShiftAutomatic = value.is_string();
                if (value.is_array()) {
                    keysOf(reading).maskShiftPx = value.get<Eigen::Vector2d>();
                }
            },
            [](const RunTreatment& treatment, const fs::path&) {
                return treatment.plan.maskShiftPx ? Json(*treatment.plan.maskShiftPx) : Json("automatic");
            }};
}

StoredField<RunTreatment> relationField()
{
    using core::PixelRelation;
    return {"pixelRelation", choiceSchema({"linear", "logarithmic"}),
            [](const Json& value, RunTreatment&, Reading& reading) {
                keysOf(reading).relation = value == "logarithmic" ? PixelRelation::Logarithmic : PixelRelation::Linear;
            },
            [](const RunTreatment& treatment, const fs::path&) {
                return Json(treatment.plan.relation == PixelRelation::Linear ? "linear" : "logarithmic");
            }};
}

StoredField<RunTreatment> polarityField()
{
    using core::Polarity;
    return {"vessels", about(choiceSchema({"dark", "bright"}), "Absent: as given by the image."),
            [](const Json& value, RunTreatment& treatment, Reading&) {
                treatment.polarity = value == "bright" ? Polarity::VesselsBright : Polarity::VesselsDark;
            },
            [](const RunTreatment& treatment, const fs::path&) {
                return treatment.polarity ? Json(treatment.polarity == Polarity::VesselsBright ? "bright" : "dark")
                                          : Json();
            }};
}

StoredFields<RunTreatment> treatmentFields()
{
    return {storedValue("on", about(flagSchema(), "Whether mask frames are subtracted; absent: yes."),
                        &RunTreatment::isSubtracted),
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
    StoredField<View> field = storedPart("subtraction", schema, &View::treatment, treatmentFields());
    field.read = [read = field.read](const Json& value, View& view, Reading& reading) {
        reading.view.subtraction.emplace();
        view.treatment.isSubtracted = true;
        read(value, view, reading);
    };
    return writtenWhere([](const View& view) { return view.treatment != RunTreatment{.plan = view.headerPlan}; },
                        std::move(field));
}

}   // namespace angiopose::io
