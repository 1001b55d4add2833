#include "app/words/measure_words.h"

#include "core/measuring/measure_image.h"
#include "core/messages/messages.h"
#include "ui/slices/slice_model.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"

#include <QCoreApplication>

#include <array>

namespace angiopose::app {
namespace {

struct MeasureWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::MeasureWords)
};

template <class Measurement>
QString nameOf(const Measurement& measurement)
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

QString inScan(const QString& value)
{
    return MeasureWords::tr("%1 in the scan").arg(value);
}

QString sliceWords(const core::SliceMeasurement& measurement)
{
    constexpr std::array axes{"z", "y", "x"};   // patient axes along the normals of core::bodyPlanes
    return MeasureWords::tr("%1, %2 %3 mm.")
               .arg(ui::nameOf(measurement.plane), QLatin1String(axes[static_cast<std::size_t>(measurement.plane)]),
                    ui::numberText(core::slicePositionMm(measurement), 1)) +
           QLatin1Char(' ');
}

QString frameWords(const core::ImageMeasurement& measurement)
{
    return MeasureWords::tr("Frame %1.").arg(measurement.frame + 1) + QLatin1Char(' ');
}

}   // namespace

ui::MeasureRow measureRow(const core::ImageMeasurement& measurement, const core::MeasurementContext& context)
{
    const QString frame = frameWords(measurement);
    const auto measured = core::measureImage(measurement, context);
    if (!measured) {
        return {nameOf(measurement), QStringLiteral("–"), frame + ui::messageText(measured.error().message), true};
    }
    const core::ImageScale& scale = measured.value().scale;
    return {nameOf(measurement), ui::messageText(core::labelOf(measured.value(), measurement.kind)),
            frame + ui::messagesText(core::basisOf(measured.value(), measurement.kind, context)),
            scale.isInMm() && scale.origin == core::Origin::Assumed};
}

ui::MeasureRow sliceRow(const core::SliceMeasurement& measurement, const core::VolumeGeometry* scan)
{
    const QString slice = sliceWords(measurement);
    const auto value = core::valueOf(measurement);
    if (!value) {
        return {nameOf(measurement), QStringLiteral("–"), slice + ui::messageText(value.error().message), true};
    }
    return {nameOf(measurement), inScan(sliceLabel(measurement)),
            slice + ui::messagesText(core::basisOf(measurement, scan)), false};
}

QString sliceLabel(const core::SliceMeasurement& measurement)
{
    const auto value = core::valueOf(measurement);
    return value ? ui::messageText(core::messages::measuredPlain(value.value())) : QString();
}

QString planeBasis(core::MeasurementPlane plane, const core::MeasurementContext& context)
{
    const auto scale = core::imageScaleOf(context, plane);
    return scale ? ui::messagesText(core::basisOf({{}, scale.value()}, core::MeasurementKind::Length, context))
                 : ui::messageText(scale.error().message);
}

QString measureLabel(const core::ImageMeasurement& measurement, const core::MeasurementContext& context)
{
    const auto measured = core::measureImage(measurement, context);
    return measured ? ui::messageText(core::labelOf(measured.value(), measurement.kind)) : QString();
}

std::vector<ui::ImageMark> windowMarks(const core::MeasurementContext& context, int frame)
{
    return marksOf(context, frame, [](const core::Message& message) { return ui::messageText(message).toStdString(); });
}

std::vector<ui::ImageMark> windowPlacedMarks(const MarkedView& placed)
{
    return placedMarks(placed, [](const core::Message& message) { return ui::messageText(message).toStdString(); });
}

}   // namespace angiopose::app
