#include "io/dicom/c_arm_tags.h"

#include "io/dicom/functional_groups.h"
#include "io/dicom/siemens_tags.h"
#include "io/messages/messages.h"
#include "io/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace angiopose::io {
namespace {

using core::CArm;
using core::Origin;
using core::SourcedValue;

constexpr DicomTag sharedGroups = 0x52009229;

constexpr DicomTag sidTag = 0x00181110;
constexpr DicomTag sodTag = 0x00181111;
constexpr DicomTag magnificationTag = 0x00181114;
constexpr DicomTag isocenterTag = 0x00189402;
constexpr DicomTag primaryAngleTag = 0x00181510;
constexpr DicomTag secondaryAngleTag = 0x00181511;
constexpr DicomTag imagerSpacingTag = 0x00181164;
constexpr DicomTag pixelSpacingTag = 0x00280030;
constexpr DicomTag fieldOfViewTag = 0x00181149;
constexpr DicomTag rowsTag = 0x00280010;
constexpr DicomTag columnsTag = 0x00280011;

core::Quantity millimeters(double value)
{
    return {std::round(value * 1e4) / 1e4, core::Quantity::significantDigits, "mm"};
}

/// Copies elements that are missing at the top level from the functional group sequences, up to two levels deep.
void addFromGroups(DicomDataset& data, DicomTag groupsTag)
{
    const std::vector<DicomDataset> groups = data.items(groupsTag);
    if (groups.empty()) {
        return;
    }
    for (const DicomDataset& content : groups.front().itemsOfAllSequences()) {
        data.addMissingFrom(content);
    }
}

SourcedValue<double> fromHeader(const DicomDataset& data, DicomTag tag, const std::string& basis)
{
    const auto value = data.number(tag);
    return value ? SourcedValue<double>{value, Origin::Header, basis} : SourcedValue<double>{};
}

bool isPositive(std::optional<double> value)
{
    return value && *value > 0.0;
}

/// Reads the isocenter distance as Siemens systems write it; nullopt if it is implausible for a C-arm.
std::optional<double> privateIsocenterMm(const DicomDataset& data, const CArm& cArm, DicomTag tag)
{
    const auto value = data.number(tag);
    const bool isOne = value && *value >= 500.0 && *value <= 1000.0 &&
                       *value < cArm.sourceToDetectorMm.value.value_or(std::numeric_limits<double>::infinity());
    return isOne ? value : std::nullopt;
}

/// Reads the distances from the source. The isocenter has its own tags; (0018,1111) is the distance to the plane of the
/// object that the system assumes at some height above the table (PS3.3 C.8.19.6.9.1): the isocenter in older systems,
/// often another plane in current ones.
void readDistances(const DicomDataset& data, CArm& cArm, core::Messages& warnings)
{
    if (isPositive(data.number(sidTag))) {
        cArm.sourceToDetectorMm = fromHeader(data, sidTag, "(0018,1110) Distance Source to Detector");
    }
    const auto magnification = data.number(magnificationTag);
    if (isPositive(data.number(sodTag))) {
        cArm.sourceToObjectMm = fromHeader(data, sodTag, "(0018,1111) Distance Source to Patient");
    } else if (magnification && *magnification > 1.0 && cArm.sourceToDetectorMm.value) {
        cArm.sourceToObjectMm = {*cArm.sourceToDetectorMm.value / *magnification, Origin::Derived,
                                 "SID / (0018,1114) magnification " + toText(std::round(*magnification * 1e4) / 1e4)};
    }
    if (isPositive(data.number(isocenterTag))) {
        cArm.sourceToIsocenterMm = fromHeader(data, isocenterTag, "(0018,9402) Distance Source to Isocenter");
    } else if (const auto tag = siemensTag(data, siemensIsocenter)) {
        if (const auto isocenter = privateIsocenterMm(data, cArm, *tag)) {
            cArm.sourceToIsocenterMm = {isocenter, Origin::Header, tagText(*tag) + " Siemens, source to isocenter"};
        }
    }
    const auto& [isocenter, object] = std::tie(cArm.sourceToIsocenterMm, cArm.sourceToObjectMm);
    if (isocenter.value && object.value && std::abs(*isocenter.value - *object.value) > 1.0) {
        warnings.push_back(messages::objectOffIsocenter(millimeters(*object.value), millimeters(*isocenter.value))
                               .as(core::Severity::Note));
    }
    assumeIsocenter(cArm);
}

void setSpacing(CArm& cArm, const Eigen::Vector2d& rowColumnMm, Origin origin, const std::string& basis)
{
    cArm.rowSpacingMm = {rowColumnMm.x(), origin, basis};
    cArm.columnSpacingMm = {rowColumnMm.y(), origin, basis};
}

std::optional<Eigen::Vector2d> positivePair(const DicomDataset& data, DicomTag tag)
{
    const auto first = data.number(tag, 0), second = data.number(tag, 1);
    return isPositive(first) && isPositive(second) ? std::optional(Eigen::Vector2d(*first, *second)) : std::nullopt;
}

/// Returns the pixel spacing (row, column), mm, derived from a field of view that covers the undistorted whole image.
std::optional<Eigen::Vector2d> fieldSpacing(const DicomDataset& data)
{
    const auto rows = data.number(rowsTag), columns = data.number(columnsTag);
    const auto rowDimension = data.number(fieldOfViewTag, 0);
    const auto columnDimension = data.number(fieldOfViewTag, 1);
    if (!isPositive(rows) || !isPositive(columns) || !isPositive(rowDimension) || !isPositive(columnDimension) ||
        data.text(0x00181147) != "RECTANGLE") {
        return std::nullopt;
    }
    // PS3.3, "row dimension followed by column": the first value extends along a row, that is, across the columns.
    const Eigen::Vector2d spacing(*columnDimension / *rows, *rowDimension / *columns);
    const bool isPlausible = spacing.minCoeff() > 0.05 && spacing.maxCoeff() < 2.0;
    return isPlausible && std::abs(spacing.x() / spacing.y() - 1.0) < 0.01 ? std::optional(spacing) : std::nullopt;
}

/// Reads the pixel spacing from the first available of (ALGORITHMS §5.2): imager pixel spacing, calibrated pixel
/// spacing, field of view. Leaves the spacing unset if none is available.
void readSpacing(const DicomDataset& data, CArm& cArm, core::Messages& warnings)
{
    if (const auto imager = positivePair(data, imagerSpacingTag)) {
        setSpacing(cArm, *imager, Origin::Header, "(0018,1164) Imager Pixel Spacing");
        return;
    }
    const auto pixel = positivePair(data, pixelSpacingTag);
    const std::string_view calibration = data.text(0x00280a02);
    if (pixel && !calibration.empty() && cArm.sourceToDetectorMm.value && vesselDepthOf(cArm).value) {
        const double magnification = *cArm.sourceToDetectorMm.value / *vesselDepthOf(cArm).value;
        setSpacing(cArm, *pixel * magnification, Origin::Derived,
                   "(0028,0030) Pixel Spacing (" + std::string(calibration.substr(0, 16)) + ") times SID/SOD");
        warnings.push_back(messages::spacingFromCalibration(millimeters(*cArm.columnSpacingMm.value)));
    } else if (const auto field = fieldSpacing(data)) {
        setSpacing(cArm, *field, Origin::Derived,
                   "(0018,1149) field of view " + std::string(data.text(fieldOfViewTag, 0)) + " mm / " +
                       std::to_string(data.integer(columnsTag).value_or(0)) + " px");
        warnings.push_back(messages::spacingFromField(millimeters(field->y())));
    } else if (const auto intensifier = data.number(0x00181162); isPositive(intensifier)) {
        warnings.push_back(messages::spacingMissingIntensifier(
            millimeters(*intensifier), millimeters(*intensifier / data.number(columnsTag).value_or(512.0))));
    } else {
        warnings.push_back(messages::spacingMissing());
    }
}

void readAngles(const DicomDataset& data, CArm& cArm, core::Messages& warnings)
{
    cArm.primaryAngleDeg = fromHeader(data, primaryAngleTag, "(0018,1510) Positioner Primary Angle");
    cArm.secondaryAngleDeg = fromHeader(data, secondaryAngleTag, "(0018,1511) Positioner Secondary Angle");
    if (!cArm.primaryAngleDeg.value && data.has(0x00189463)) {
        warnings.push_back(messages::anglesOfIsocenter());
    }
    const double detectorTilt =
        std::max(std::abs(data.number(0x00181530).value_or(0.0)), std::abs(data.number(0x00181531).value_or(0.0)));
    if (detectorTilt > 0.5) {
        warnings.push_back(
            messages::detectorTilted(core::Quantity{detectorTilt, core::Quantity::significantDigits, "°"}));
    }
}

/// Computes the principal point in the stored image from the position of the field of view on the detector; applies the
/// rotation first, then the flip (ALGORITHMS §5.2).
void readPrincipalPoint(const DicomDataset& data, CArm& cArm)
{
    const auto element = positivePair(data, 0x00187022);   // spacing of the detector elements, mm
    const auto active = positivePair(data, 0x00187026);   // active dimensions of the detector, mm
    const auto originRow = data.number(0x00187030, 0), originColumn = data.number(0x00187030, 1);
    const auto rows = data.number(rowsTag), columns = data.number(columnsTag);
    if (!element || !active || !originRow || !originColumn || !rows || !columns || !cArm.rowSpacingMm.value) {
        return;
    }
    // Active dimensions and origins refer to the top left corner of the active area.
    double cy = (0.5 * active->x() - *originRow * element->x()) / *cArm.rowSpacingMm.value - 0.5;
    double cx = (0.5 * active->y() - *originColumn * element->y()) / *cArm.columnSpacingMm.value - 0.5;
    double width = *columns, height = *rows;
    const int turns = static_cast<int>(std::lround(data.number(0x00187032).value_or(0.0) / 90.0)) & 3;
    if (turns % 2 == 1) {
        std::swap(width, height);   // image size before the rotation
    }
    for (int i = 0; i < turns; ++i) {   // a clockwise quarter turn maps (u, v) to (height − 1 − v, u)
        const double u = height - 1.0 - cy;
        cy = cx;
        cx = u;
        std::swap(width, height);
    }
    if (data.text(0x00187034) == "YES") {
        cx = width - 1.0 - cx;
    }
    if (std::abs(cx) < 10.0 * width && std::abs(cy) < 10.0 * height) {
        cArm.principalPointPx = {Eigen::Vector2d(cx, cy), Origin::Derived, "(0018,7030) Field of View Origin"};
    }
}

/// Returns the direction given by the letters of Patient Orientation, dominant direction first, for example "LA"; zero
/// if a letter is invalid.
Eigen::Vector3d directionOf(std::string_view letters)
{
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    double weight = 1.0;
    for (const char letter : letters) {
        constexpr std::string_view positive = "LPH", negative = "RAF";
        const auto axis = std::min(positive.find(letter), negative.find(letter));
        if (axis == std::string_view::npos) {
            return Eigen::Vector3d::Zero();   // direction of a limb or of another species
        }
        direction[static_cast<Eigen::Index>(axis)] += positive.find(letter) == axis ? weight : -weight;
        weight *= 0.6;
    }
    return direction.stableNormalized();
}

/// Determines whether the image is shown as seen from the source, and its quarter turn, from the one of all eight
/// orientations whose rows and columns best match the letters of Patient Orientation. The flip tag is only a hint.
void readOrientation(const DicomDataset& data, CArm& cArm, core::Messages& warnings)
{
    constexpr DicomTag orientationTag = 0x00200020;
    constexpr double minLetterAgreement = 0.45;   // minimum agreement; the letters state only coarse directions
    const Eigen::Vector3d row = directionOf(data.text(orientationTag, 0));
    const Eigen::Vector3d column = directionOf(data.text(orientationTag, 1));
    CArm likeliest = cArm;
    double most = 0.0;
    for (const bool mirrored : {false, true}) {
        for (const double rollDeg : {0.0, 90.0, 180.0, -90.0}) {
            CArm candidate = cArm;
            candidate.mirrored = {mirrored, Origin::Header, "(0020,0020) Patient Orientation"};
            if (rollDeg != 0.0) {
                candidate.rollDeg = {rollDeg, Origin::Header, "(0020,0020) Patient Orientation"};
            }
            const core::ImageAxes axes = imageAxesOf(candidate);
            const bool isUpright = rollDeg == 0.0;
            const double alongRow = row.dot(axes.right);
            const double alongColumn = column.isZero() ? (isUpright ? 1.0 : 0.0) : column.dot(axes.down);
            const double likeness =
                std::min(alongRow, alongColumn) >= minLetterAgreement ? alongRow + alongColumn : 0.0;
            if (likeness > most + 1e-9) {
                most = likeness;
                likeliest = std::move(candidate);
            }
        }
    }
    if (most > 0.0) {
        cArm = std::move(likeliest);
    } else {
        if (!row.isZero() && cArm.primaryAngleDeg.value) {
            warnings.push_back(messages::orientationUnlikeAngles(std::string(data.text(orientationTag))));
        }
        if (data.text(0x00187034) == "YES") {
            cArm.mirrored = {true, Origin::Derived, "(0018,7034) Field of View Horizontal Flip"};
        }
    }
    if (cArm.mirrored.value.value_or(false)) {
        warnings.push_back(messages::imageMirrored(cArm.mirrored.basis));
    }
    if (cArm.rollDeg.value) {
        warnings.push_back(messages::imageTurned(core::Quantity{*cArm.rollDeg.value, 0, "°"}, cArm.rollDeg.basis));
    }
}

}   // namespace

DicomDataset withFunctionalGroups(const DicomDataset& data)
{
    DicomDataset flat = data;
    addFromGroups(flat, perFrameGroupsTag);
    addFromGroups(flat, sharedGroups);
    return flat;
}

core::CArm cArmOf(const DicomDataset& data, core::Messages& warnings)
{
    const DicomDataset flat = withFunctionalGroups(data);
    CArm cArm;
    readDistances(flat, cArm, warnings);
    readSpacing(flat, cArm, warnings);
    readAngles(flat, cArm, warnings);
    readPrincipalPoint(flat, cArm);
    readOrientation(flat, cArm, warnings);
    return cArm;
}

bool isMissingSpacingWarning(const core::Message& warning)
{
    return warning.is(messages::spacingFromCalibration) || warning.is(messages::spacingFromField) ||
           warning.is(messages::spacingMissing) || warning.is(messages::spacingMissingIntensifier);
}

}   // namespace angiopose::io
