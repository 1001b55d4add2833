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
    return {"composite",
            about(choiceSchema({"none", "minimum"}), "minimum: every frame shows all the contrast medium of the run."),
            [](const Json& value, RunTreatment& treatment, Reading&) { treatment.isComposite = value == "minimum"; },
            [](const RunTreatment& treatment, const fs::path&) {
                return Json(treatment.isComposite ? "minimum" : "none");
            }};
}

StoredField<RunTreatment> maskFramesField()
{
    return {"maskFrames",
            about(listSchema(integerSchema(0, 100000)), "Averaged, counted from 0; empty: chosen automatically."),
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
                  "One mask for each frame instead of averaged ones: offset frames before it (TID); with reversedFrom, "
                  "masks go backwards from there (REV_TID)."),
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
                  "Right, down, for every frame; or found for each."),
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
    return {"vessels", about(choiceSchema({"dark", "bright"}), "Absent: as the image says."),
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
    return {storedValue("on", about(flagSchema(), "Mask frames are subtracted; absent: they are."),
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
                       "How the stored frames become the run that is shown and traced. Absent keys: as the image's "
                       "header has them."}};
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
