#include "app/texts/image_marks.h"

#include "core/measuring/measure_image.h"

namespace angiopose::app {
namespace {

ui::MarkShape shapeOfMark(core::MeasurementKind kind)
{
    switch (kind) {
        case core::MeasurementKind::Length:
            return ui::MarkShape::Length;
        case core::MeasurementKind::Angle:
            return ui::MarkShape::Angle;
        case core::MeasurementKind::Area:
            break;
    }
    return ui::MarkShape::Outline;
}

}   // namespace

std::vector<ui::ImageMark> marksOf(const core::MeasuredView& seen, int frame,
                                   const std::function<std::string(const core::Message&)>& toText)
{
    std::vector<ui::ImageMark> marks;
    for (const core::ImageMeasurement& measurement : seen.view.measurements) {
        if (measurement.frame != frame) {
            continue;
        }
        const auto measured = core::measureImage(measurement, seen);
        const std::string value = measured ? toText(core::labelOf(measured.value(), measurement.kind)) : "–";
        const std::string label = measurement.name.empty() ? value : measurement.name + " " + value;
        marks.push_back({shapeOfMark(measurement.kind), measurement.pixels, label});
    }
    return marks;
}

}   // namespace angiopose::app
