#include "ui/panels/geometry_values.h"

namespace angiopose::ui {
namespace {

using core::Origin;
using core::SourcedValue;

NumberFormat millimeters(double min, double max, int decimals, double step)
{
    return {min, max, decimals, QStringLiteral("mm"), step};
}

NumberFormat degrees(double limit)
{
    return {-limit, limit, 1, QStringLiteral("°"), 1.0, NumberSign::Always};
}

NumberFormat pixels()
{
    return {-100000.0, 100000.0, 1, QStringLiteral("px"), 1.0};
}

const std::array<GeometryValueInfo, geometryValueCount>& kinds()
{
    static const std::array<GeometryValueInfo, geometryValueCount> table{
        {{QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "SID"),
          QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "Source-to-detector distance"),
          millimeters(100.0, 3000.0, 1, 1.0), 1000.0, true},
         {QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "SOD"),
          QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "Source-to-isocenter distance"),
          millimeters(100.0, 3000.0, 1, 1.0), 750.0, true},
         {QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "pixel spacing"),
          QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel",
                            "Pixel spacing at the detector. Press Enter to confirm a derived value."),
          millimeters(0.01, 5.0, 4, 0.01), 0.3, true},
         {QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "detector width"),
          QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel",
                            "Width of the image at the detector; determines the pixel spacing"),
          millimeters(10.0, 1000.0, 1, 1.0), 0.0, false},
         {QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "LAO / RAO"),
          QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "Primary angle: LAO positive, RAO negative"),
          degrees(180.0), 0.0, true},
         {QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "CRA / CAU"),
          QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "Secondary angle: CRA positive, CAU negative"),
          degrees(90.0), 0.0, true},
         {QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "roll"),
          QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "Clockwise rotation of the image"), degrees(180.0), 0.0,
          false},
         {QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "center x"),
          QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel",
                            "Column in which the central ray meets the detector; 0 is the center of the first column"),
          pixels(), 0.0, false},
         {QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "center y"),
          QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel",
                            "Row in which the central ray meets the detector; 0 is the center of the first row"),
          pixels(), 0.0, false},
         {QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "isocenter L"),
          QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "Gantry rotation center in vessel coordinates: left"),
          millimeters(-100000.0, 100000.0, 1, 1.0), 0.0, false},
         {QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "isocenter P"),
          QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "Gantry rotation center in vessel coordinates: posterior"),
          millimeters(-100000.0, 100000.0, 1, 1.0), 0.0, false},
         {QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "isocenter H"),
          QT_TRANSLATE_NOOP("angiopose::ui::GeometryPanel", "Gantry rotation center in vessel coordinates: head"),
          millimeters(-100000.0, 100000.0, 1, 1.0), 0.0, false}}};
    return table;
}

/// Returns one coordinate of `point`, or of its substitute if the point is unknown.
template <class Point>
SourcedValue<double> coordinate(const SourcedValue<Point>& point, const std::optional<Point>& standIn,
                                Eigen::Index index, const char* standInBasis)
{
    if (point.value) {
        return {(*point.value)[index], point.origin, point.basis};
    }
    return standIn ? SourcedValue<double>{(*standIn)[index], Origin::Assumed, standInBasis} : SourcedValue<double>{};
}

std::optional<Eigen::Vector2d> imageCenter(const GeometryState& state)
{
    return state.imageSizePx.minCoeff() > 0
               ? std::optional<Eigen::Vector2d>(0.5 * (state.imageSizePx.cast<double>().array() - 1.0).matrix())
               : std::nullopt;
}

template <class Point>
void setCoordinate(SourcedValue<Point>& point, const std::optional<Point>& standIn, Eigen::Index index,
                   const SourcedValue<double>& number)
{
    Point moved = point.value ? *point.value : standIn.value_or(Point::Zero());
    moved[index] = *number.value;
    point = {moved, number.origin, number.basis};
}

Eigen::Index indexFrom(GeometryValue first, GeometryValue value)
{
    return static_cast<Eigen::Index>(value) - static_cast<Eigen::Index>(first);
}

}   // namespace

const GeometryValueInfo& infoOf(GeometryValue value)
{
    return kinds()[static_cast<std::size_t>(value)];
}

SourcedValue<double> shownValue(const GeometryState& state, GeometryValue value)
{
    const core::CArm& cArm = state.cArm;
    switch (value) {
        case GeometryValue::Sid:
            return cArm.sourceToDetectorMm;
        case GeometryValue::Sod:
            return cArm.sourceToIsocenterMm;
        case GeometryValue::Spacing:
            return cArm.columnSpacingMm;
        case GeometryValue::FieldWidth: {
            SourcedValue<double> width = cArm.columnSpacingMm;
            if (width.value && state.imageSizePx.x() > 0) {
                width = {*width.value * state.imageSizePx.x(), Origin::Derived, "columns × pixel spacing"};
                return width;
            }
            return {};
        }
        case GeometryValue::Primary:
            return cArm.primaryAngleDeg;
        case GeometryValue::Secondary:
            return cArm.secondaryAngleDeg;
        case GeometryValue::Roll:
            return cArm.rollDeg.value ? cArm.rollDeg : SourcedValue<double>{0.0, Origin::Assumed, "not in the header"};
        case GeometryValue::CenterX:
        case GeometryValue::CenterY:
            return coordinate(cArm.principalPointPx, imageCenter(state), indexFrom(GeometryValue::CenterX, value),
                              "center of the image");
        case GeometryValue::IsocenterX:
        case GeometryValue::IsocenterY:
        case GeometryValue::IsocenterZ:
            break;
    }
    return coordinate(cArm.isocenterInPatientMm, state.vesselCentroidMm, indexFrom(GeometryValue::IsocenterX, value),
                      "centroid of the vessels");
}

core::CArm withValue(const GeometryState& state, GeometryValue value, double number, Origin origin,
                     const std::string& basis)
{
    core::CArm cArm = state.cArm;
    const SourcedValue<double> typed{number, origin, basis};
    switch (value) {
        case GeometryValue::Sid:
            cArm.sourceToDetectorMm = typed;
            break;
        case GeometryValue::Sod:
            cArm.sourceToIsocenterMm = typed;
            break;
        case GeometryValue::FieldWidth:
            if (state.imageSizePx.x() > 0) {
                const double pitch = number / state.imageSizePx.x();
                cArm.columnSpacingMm = {pitch, origin,
                                        "detector width / " + std::to_string(state.imageSizePx.x()) + " px"};
                cArm.rowSpacingMm = cArm.columnSpacingMm;
            }
            break;
        case GeometryValue::Spacing: {
            // Preserves the pixel aspect ratio of the header.
            const bool hasBoth = state.cArm.columnSpacingMm.value && state.cArm.rowSpacingMm.value;
            const double aspect = hasBoth ? *state.cArm.rowSpacingMm.value / *state.cArm.columnSpacingMm.value : 1.0;
            cArm.columnSpacingMm = typed;
            cArm.rowSpacingMm = {number * aspect, origin, basis};
            break;
        }
        case GeometryValue::Primary:
            cArm.primaryAngleDeg = typed;
            break;
        case GeometryValue::Secondary:
            cArm.secondaryAngleDeg = typed;
            break;
        case GeometryValue::Roll:
            cArm.rollDeg = typed;
            break;
        case GeometryValue::CenterX:
        case GeometryValue::CenterY:
            setCoordinate(cArm.principalPointPx, imageCenter(state), indexFrom(GeometryValue::CenterX, value), typed);
            break;
        case GeometryValue::IsocenterX:
        case GeometryValue::IsocenterY:
        case GeometryValue::IsocenterZ:
            setCoordinate(cArm.isocenterInPatientMm, state.vesselCentroidMm,
                          indexFrom(GeometryValue::IsocenterX, value), typed);
            break;
    }
    return cArm;
}

}   // namespace angiopose::ui
