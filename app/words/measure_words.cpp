#include "app/words/measure_words.h"

#include "app/texts/image_marks.h"
#include "core/measuring/measure_image.h"
#include "ui/words/message_text.h"

#include <QCoreApplication>

namespace angiopose::app {
namespace {

/// The words of this file.
struct MeasureWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::MeasureWords)
};

QString nameOf(const core::ImageMeasurement& measurement)
{
    if (!measurement.name.empty()) {
        return QString::fromStdString(measurement.name);
    }
    switch (measurement.kind) {
        case core::MeasurementKind::Length:
            return MeasureWords::tr("Length");
        case core::MeasurementKind::Angle:
            return MeasureWords::tr("Angle");
        case core::MeasurementKind::Area:
            break;
    }
    return MeasureWords::tr("Area");
}

QString frameWords(const core::ImageMeasurement& measurement)
{
    return MeasureWords::tr("Frame %1.").arg(measurement.frame) + QLatin1Char(' ');
}

}   // namespace

ui::MeasureRow measureRow(const core::ImageMeasurement& measurement, const core::MeasuredView& seen)
{
    const QString frame = frameWords(measurement);
    const auto measured = core::measureImage(measurement, seen);
    if (!measured) {
        return {nameOf(measurement), QStringLiteral("–"), frame + ui::messageText(measured.error().message), true};
    }
    const core::ImageScale& scale = measured.value().scale;
    return {nameOf(measurement), ui::messageText(core::labelOf(measured.value(), measurement.kind)),
            frame + ui::messagesText(core::basisOf(measured.value(), measurement.kind, seen)),
            scale.isInMm() && scale.origin == core::Origin::Assumed};
}

QString planeBasis(core::MeasurementPlane plane, const core::MeasuredView& seen)
{
    const auto scale = core::imageScaleOf(seen, plane);
    return scale ? ui::messagesText(core::basisOf({{}, scale.value()}, core::MeasurementKind::Length, seen))
                 : ui::messageText(scale.error().message);
}

QString measureLabel(const core::ImageMeasurement& measurement, const core::MeasuredView& seen)
{
    const auto measured = core::measureImage(measurement, seen);
    return measured ? ui::messageText(core::labelOf(measured.value(), measurement.kind)) : QString();
}

std::vector<ui::ImageMark> windowMarks(const core::MeasuredView& seen, int frame)
{
    return marksOf(seen, frame, [](const core::Message& message) { return ui::messageText(message).toStdString(); });
}

std::vector<ui::ImageMark> windowPlacedMarks(const PlacedView& placed)
{
    return placedMarks(placed, [](const core::Message& message) { return ui::messageText(message).toStdString(); });
}

}   // namespace angiopose::app
