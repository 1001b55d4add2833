#include "io/dicom/gantry_tags.h"

#include "io/dicom/c_arm_tags.h"
#include "io/dicom/functional_groups.h"
#include "io/dicom/siemens_tags.h"
#include "io/messages/messages.h"
#include "io/support/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace angiopose::io {
namespace {

using core::GantryHeader;

constexpr DicomTag positionerPosition = 0x00189405;
constexpr DicomTag primaryAngle = 0x00181510, secondaryAngle = 0x00181511;
constexpr DicomTag primaryIncrement = 0x00181520, secondaryIncrement = 0x00181521;
constexpr std::size_t maxValuesShown = 6;

struct GeometryTag {
    DicomTag tag;
    const char* name;   ///< attribute name according to PS3.6
};

constexpr std::array geometryTags{
    GeometryTag{0x00081090, "Manufacturer's Model Name"},
    GeometryTag{0x00181110, "Distance Source to Detector"},
    GeometryTag{0x00181111, "Distance Source to Patient"},
    GeometryTag{0x00181114, "Estimated Radiographic Magnification Factor"},
    GeometryTag{0x00181130, "Table Height"},
    GeometryTag{0x00181134, "Table Motion"},
    GeometryTag{0x00181135, "Table Vertical Increment"},
    GeometryTag{0x00181136, "Table Lateral Increment"},
    GeometryTag{0x00181137, "Table Longitudinal Increment"},
    GeometryTag{0x00181138, "Table Angle"},
    GeometryTag{0x00181147, "Field of View Shape"},
    GeometryTag{0x00181149, "Field of View Dimension(s)"},
    GeometryTag{0x00181162, "Intensifier Size"},
    GeometryTag{0x00181164, "Imager Pixel Spacing"},
    GeometryTag{0x00181500, "Positioner Motion"},
    GeometryTag{primaryAngle, "Positioner Primary Angle"},
    GeometryTag{secondaryAngle, "Positioner Secondary Angle"},
    GeometryTag{primaryIncrement, "Positioner Primary Angle Increment"},
    GeometryTag{secondaryIncrement, "Positioner Secondary Angle Increment"},
    GeometryTag{0x00181530, "Detector Primary Angle"},
    GeometryTag{0x00181531, "Detector Secondary Angle"},
    GeometryTag{0x00185100, "Patient Position"},
    GeometryTag{0x00187022, "Detector Element Spacing"},
    GeometryTag{0x00187026, "Detector Active Dimension(s)"},
    GeometryTag{0x00187028, "Detector Active Origin"},
    GeometryTag{0x00187030, "Field of View Origin"},
    GeometryTag{0x00187032, "Field of View Rotation"},
    GeometryTag{0x00187034, "Field of View Horizontal Flip"},
    GeometryTag{0x00189402, "Distance Source to Isocenter"},
    GeometryTag{0x00189463, "Positioner Isocenter Primary Angle"},
    GeometryTag{0x00189464, "Positioner Isocenter Secondary Angle"},
    GeometryTag{0x00189465, "Positioner Isocenter Detector Rotation Angle"},
    GeometryTag{0x00189466, "Table X Position to Isocenter"},
    GeometryTag{0x00189467, "Table Y Position to Isocenter"},
    GeometryTag{0x00189468, "Table Z Position to Isocenter"},
    GeometryTag{0x00189469, "Table Horizontal Rotation Angle"},
    GeometryTag{0x00189470, "Table Head Tilt Angle"},
    GeometryTag{0x00189471, "Table Cradle Tilt Angle"},
    GeometryTag{0x00200020, "Patient Orientation"},
    GeometryTag{0x00280030, "Pixel Spacing"},
    GeometryTag{0x00280034, "Pixel Aspect Ratio"},
    GeometryTag{0x00280a02, "Pixel Spacing Calibration Type"},
};

constexpr std::array siemensGeometryTags{
    GeometryTag{siemensIsocenter, "Siemens, Source to Isocenter"},
    GeometryTag{siemensTableMoves, "Siemens, Table Movement Flag"},
    GeometryTag{siemensTable, "Siemens, Table Position"},
};

/// Formats the values for display, for example "200, 200"; truncates a long list, which then ends with its length.
std::string valueText(const DicomDataset& data, DicomTag tag)
{
    const bool isBinary = data.isBinaryNumber(tag) || tag >> 16U == siemensBlock >> 16U;
    std::string text;
    std::size_t count = 0;
    for (;; ++count) {
        const auto number = isBinary ? data.number(tag, count) : std::nullopt;
        const std::string value = isBinary ? (number ? toText(*number) : "") : std::string(data.text(tag, count));
        if (value.empty()) {
            break;
        }
        if (count < maxValuesShown) {
            text += (count > 0 ? ", " : "") + value;
        }
    }
    return count > maxValuesShown ? text + ", … (" + std::to_string(count) + " values)" : text;
}

void readTags(const DicomDataset& data, GantryHeader& header)
{
    for (const GeometryTag& known : geometryTags) {
        if (data.has(known.tag)) {
            std::string value = valueText(data, known.tag);
            header.tags.push_back({tagText(known.tag), known.name, value.empty() ? "(empty)" : std::move(value)});
        }
    }
    for (const GeometryTag& known : siemensGeometryTags) {
        if (const auto tag = siemensTag(data, known.tag)) {
            header.tags.push_back({tagText(*tag), known.name, valueText(data, *tag)});
        }
    }
    std::ranges::stable_sort(header.tags, {}, &core::HeaderTag::tag);
}

std::optional<double> positive(const DicomDataset& data, DicomTag tag, std::size_t index = 0)
{
    const auto value = data.number(tag, index);
    return value && *value > 0.0 ? value : std::nullopt;
}

std::optional<Eigen::Vector2d> positivePairIn(const DicomDataset& data, DicomTag tag)
{
    const auto first = positive(data, tag, 0), second = positive(data, tag, 1);
    return first && second ? std::optional(Eigen::Vector2d(*first, *second)) : std::nullopt;
}

/// Reads the field of view (PS3.3 C.8.7.3.1.3). If the field is rectangular, the values are the row and column
/// dimensions, the first along a row; if it is round, the value is the diameter. The image may be cropped from a round
/// field of view, so the diameter does not determine the extent of the image.
void readFieldOfView(const DicomDataset& data, GantryHeader& header)
{
    if (data.text(0x00181147) == "RECTANGLE") {
        header.fieldOfViewMm = positivePairIn(data, 0x00181149);
    } else if (const auto diameter = positive(data, 0x00181149); diameter && data.text(0x00181147) == "ROUND") {
        header.intensifierMm = diameter;
    }
    if (const auto intensifier = positive(data, 0x00181162); intensifier && !header.intensifierMm) {
        header.intensifierMm = intensifier;
    }
}

void readSpacings(const DicomDataset& data, GantryHeader& header)
{
    if (const auto active = positivePairIn(data, 0x00187026)) {
        header.detectorMm = Eigen::Vector2d(active->y(), active->x());   // the element stores row, column
        if (std::lround(data.number(0x00187032).value_or(0.0) / 90.0) % 2 != 0) {
            std::swap(header.detectorMm->x(), header.detectorMm->y());
        }
    }
    if (const auto pixel = positivePairIn(data, 0x00280030)) {
        header.pixelSpacingMm = Eigen::Vector2d(pixel->y(), pixel->x());
        header.isPixelSpacingCalibrated = !data.text(0x00280a02).empty();
    }
    if (const auto aspect = positivePairIn(data, 0x00280034)) {
        header.pixelAspect = aspect->x() / aspect->y();   // vertical pixel size divided by the horizontal one
    }
}

/// Returns the gantry angles of each frame of an Enhanced XA object.
std::vector<Eigen::Vector2d> frameAngles(const DicomDataset& data)
{
    std::vector<Eigen::Vector2d> angles;
    for (const DicomDataset& frame : data.items(perFrameGroupsTag)) {
        const auto positions = frame.items(positionerPosition);
        const auto primary = positions.empty() ? std::nullopt : positions.front().number(primaryAngle);
        const auto secondary = positions.empty() ? std::nullopt : positions.front().number(secondaryAngle);
        if (!primary || !secondary) {
            return {};
        }
        angles.emplace_back(*primary, *secondary);
    }
    return angles;
}

/// Returns the angle increments of classic XA: one per frame, relative to the first, or a single one between frames.
std::vector<Eigen::Vector2d> storedIncrements(const DicomDataset& data, std::size_t frameCount)
{
    const auto valuesOf = [&](DicomTag tag) {
        std::vector<double> values;
        while (const auto value = data.number(tag, values.size())) {
            values.push_back(*value);
        }
        if (values.size() == 1 && frameCount > 2) {
            const double step = values.front();
            values.clear();
            for (std::size_t frame = 0; frame < frameCount; ++frame) {
                values.push_back(step * static_cast<double>(frame));
            }
        }
        return values;
    };
    std::vector<double> primary = valuesOf(primaryIncrement), secondary = valuesOf(secondaryIncrement);
    const std::size_t known = std::max(primary.size(), secondary.size());
    primary.resize(known, 0.0);
    secondary.resize(known, 0.0);
    std::vector<Eigen::Vector2d> increments;
    for (std::size_t frame = 0; frame < known; ++frame) {
        increments.emplace_back(primary[frame], secondary[frame]);
    }
    return increments;
}

void readIncrements(const DicomDataset& data, int frameCount, GantryHeader& header, core::Messages& warnings)
{
    const auto frames = static_cast<std::size_t>(frameCount);
    std::vector<Eigen::Vector2d> increments = frameAngles(data);
    if (increments.empty()) {
        increments = storedIncrements(data, frames);
    } else {
        for (const Eigen::Vector2d first = increments.front(); Eigen::Vector2d & angles : increments) {
            angles -= first;
        }
    }
    const bool moves =
        std::ranges::any_of(increments, [](const Eigen::Vector2d& angles) { return angles.norm() > 1e-9; });
    if (moves && increments.size() == frames) {
        header.angleIncrementsDeg = std::move(increments);
    } else if (moves || data.text(0x00181500) == "DYNAMIC") {
        warnings.push_back(messages::gantryMoved(
            increments.empty() ? messages::gantryNoAngles() : messages::gantryAngles(increments.size()), frameCount));
    }
}

/// Reads the patient position (PS3.3 C.7.3.1.1.2) and warns unless it is head first-supine (HFS).
void readPatientPosition(const DicomDataset& data, GantryHeader& header, core::Messages& warnings)
{
    const std::string position(data.text(0x00185100));
    header.patientPosition = core::parsePatientPosition(position);
    if (!position.empty() && position != "HFS") {
        warnings.push_back(messages::patientLies(position));
    }
}

double farthest(const DicomDataset& data, DicomTag increments, std::size_t frames)
{
    double farthestMm = 0.0;
    for (std::size_t frame = 0; frame < frames; ++frame) {
        farthestMm = std::max(farthestMm, std::abs(data.number(increments, frame).value_or(0.0)));
    }
    return farthestMm;
}

void readTableMotion(const DicomDataset& data, int frameCount, GantryHeader& header, core::Messages& warnings)
{
    double farthestMm = 0.0;
    for (const DicomTag increments : {0x00181135U, 0x00181136U, 0x00181137U}) {
        farthestMm = std::max(farthestMm, farthest(data, increments, static_cast<std::size_t>(frameCount)));
    }
    const auto flag = siemensTag(data, siemensTableMoves);
    header.tableMoves =
        farthestMm > 0.0 || data.text(0x00181134) == "DYNAMIC" || (flag && data.number(*flag).value_or(0.0) == 1.0);
    if (header.tableMoves) {
        warnings.push_back(farthestMm > 0.0 ? messages::tableMoved(core::inMm(farthestMm, 0))
                                            : messages::tableMoved(messages::tableMovedUnknown()));
    }
}

std::optional<Eigen::Vector3d> tableNumbers(const DicomDataset& data, const std::array<DicomTag, 3>& tags,
                                            const std::array<std::size_t, 3>& indices)
{
    Eigen::Vector3d numbers;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto number = data.number(tags[axis], indices[axis]);
        if (!number) {
            return {};
        }
        numbers[static_cast<Eigen::Index>(axis)] = *number;
    }
    return numbers;
}

/// Computes the isocenter in patient coordinates from the table position: the table axes equal the LPS axes of a head
/// first-supine patient (PS3.3 C.8.19.6.13.1.3). Ignores a rotated or tilted table.
void readTable(const DicomDataset& data, GantryHeader& header)
{
    constexpr double maxTurnDeg = 0.1;
    for (const DicomTag turn : {0x00181138U, 0x00189469U, 0x00189470U, 0x00189471U}) {
        if (std::abs(data.number(turn).value_or(0.0)) > maxTurnDeg) {
            return;
        }
    }
    if (!header.patientPosition && !data.text(0x00185100).empty()) {
        return;   // unsupported patient position
    }
    const Eigen::Matrix3d patientFromTable =
        core::patientFromTable(header.patientPosition.value_or(core::PatientPosition::HFS));
    const auto table = tableNumbers(data, {0x00189466, 0x00189467, 0x00189468}, {0, 0, 0});
    const auto tag = siemensTag(data, siemensTable);
    if (table) {
        header.table = core::TablePosition{patientFromTable * -*table, core::TablePosition::Tags::Standard};
    } else if (const auto tenths = tag ? tableNumbers(data, {*tag, *tag, *tag}, {0, 1, 2}) : std::nullopt) {
        const Eigen::Vector3d onTable = 0.1 * Eigen::Vector3d(tenths->y(), -tenths->z(), -tenths->x());
        header.table = core::TablePosition{patientFromTable * onTable, core::TablePosition::Tags::Siemens};
    }
}

/// Converts a DICOM time, hhmmss.ffff, to seconds.
double secondsOf(std::string_view time)
{
    const double number = parseNumber(time).value_or(0.0);
    const double hours = std::floor(number / 10000.0), minutes = std::floor(number / 100.0) - 100.0 * hours;
    return 3600.0 * hours + 60.0 * minutes + std::fmod(number, 100.0);
}

/// Determines the plane of a biplane acquisition from the image type.
void readBiplane(const DicomDataset& data, GantryHeader& header)
{
    const std::string_view type = data.text(0x00080008, 2);
    const std::string_view both = data.text(0x0008002a).substr(0, 18);
    const std::string_view date = both.size() >= 14 ? both.substr(0, 8) : data.text(0x00080022);
    const std::string_view time = both.size() >= 14 ? both.substr(8) : data.text(0x00080032);
    if ((type == "BIPLANE A" || type == "BIPLANE B") && !date.empty() && !time.empty()) {
        header.biplane = core::BiplaneTime{type.back(), std::string(date), secondsOf(time)};
    }
}

}   // namespace

GantryHeader gantryHeaderOf(const DicomDataset& data, int frameCount, core::Messages& warnings)
{
    const DicomDataset flat = withFunctionalGroups(data);
    GantryHeader header;
    header.magnification = positive(flat, 0x00181114);
    readTags(flat, header);
    readFieldOfView(flat, header);
    readSpacings(flat, header);
    readIncrements(data, frameCount, header, warnings);
    readPatientPosition(flat, header, warnings);
    readTableMotion(flat, frameCount, header, warnings);
    readTable(flat, header);
    readBiplane(data, header);
    return header;
}

}   // namespace angiopose::io
