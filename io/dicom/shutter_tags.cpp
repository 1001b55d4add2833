#include "io/dicom/shutter_tags.h"

#include "io/dicom/c_arm_tags.h"
#include "io/dicom/functional_groups.h"
#include "io/messages/messages.h"
#include "io/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace angiopose::io {
namespace {

using core::Mask2d;

constexpr DicomTag shapeTag = 0x00181600;
constexpr DicomTag frameShutterTag = 0x00189472;
constexpr DicomTag verticesTag = 0x00181620;
constexpr std::size_t maxCoordinates = 8192;
constexpr double minOpenShare = 0.01;   // a smaller opening is considered an error in the header

/// Returns the mask of the pixels for which `isOpen` is true, given the column and row, which start at 1 as in DICOM.
template <class IsOpen>
Mask2d fieldWhere(int columns, int rows, const IsOpen& isOpen)
{
    Mask2d field(columns, rows);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            field.at(x, y) = isOpen(x + 1.0, y + 1.0) ? 255 : 0;
        }
    }
    return field;
}

Mask2d inRectangle(const DicomDataset& data, int columns, int rows)
{
    const auto left = data.number(0x00181602), right = data.number(0x00181604);
    const auto upper = data.number(0x00181606), lower = data.number(0x00181608);
    const bool isWhole = left && right && upper && lower;
    return fieldWhere(columns, rows, [&](double column, double row) {
        return isWhole && column >= *left && column <= *right && row >= *upper && row <= *lower;
    });
}

Mask2d inCircle(const DicomDataset& data, int columns, int rows)
{
    const auto centerRow = data.number(0x00181610, 0), centerColumn = data.number(0x00181610, 1);
    const auto radius = data.number(0x00181612);
    const bool isWhole = centerRow && centerColumn && radius;
    return fieldWhere(columns, rows, [&](double column, double row) {
        return isWhole && std::hypot(column - *centerColumn, row - *centerRow) <= *radius;
    });
}

/// Returns coordinates as alternating row and column; empty if a value is not a number.
std::vector<double> coordinatesOf(const DicomDataset& data)
{
    std::vector<double> coordinates;
    std::string_view rest = data.text(verticesTag);
    while (!rest.empty() && coordinates.size() < maxCoordinates) {
        const std::size_t end = std::min(rest.find('\\'), rest.size());
        const auto number = parseNumber(rest.substr(0, end));
        if (!number) {
            return {};
        }
        coordinates.push_back(*number);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return rest.empty() && coordinates.size() % 2 == 0 ? coordinates : std::vector<double>();
}

/// Returns the columns at which a row crosses the sides of the polygon, in ascending order. `isAbove` determines
/// whether the upper or the lower end of a side is excluded.
template <class Above>
std::vector<double> crossings(const std::vector<double>& coordinates, double row, const Above& isAbove)
{
    std::vector<double> columns;
    for (std::size_t i = 0; i + 1 < coordinates.size(); i += 2) {
        const std::size_t next = (i + 2) % coordinates.size();
        const double row1 = coordinates[i], row2 = coordinates[next];
        if (isAbove(row1, row) != isAbove(row2, row)) {
            const double share = (row - row1) / (row2 - row1);
            columns.push_back(coordinates[i + 1] + share * (coordinates[next + 1] - coordinates[i + 1]));
        }
    }
    std::ranges::sort(columns);
    return columns;
}

Mask2d inPolygon(const DicomDataset& data, int columns, int rows)
{
    const std::vector<double> coordinates = coordinatesOf(data);
    Mask2d field(columns, rows);
    for (int y = 0; y < rows; ++y) {
        const auto fill = [&](const std::vector<double>& edges) {
            for (std::size_t k = 0; k + 1 < edges.size(); k += 2) {
                const double first = std::clamp(std::ceil(edges[k] - 1e-9), 1.0, columns + 1.0);
                const double last = std::clamp(std::floor(edges[k + 1] + 1e-9), 0.0, 1.0 * columns);
                for (int x = static_cast<int>(first); x <= static_cast<int>(last); ++x) {
                    field.at(x - 1, y) = 255;
                }
            }
        };
        fill(crossings(coordinates, y + 1.0, std::less<>()));
        fill(crossings(coordinates, y + 1.0, std::less_equal<>()));
    }
    return field;
}

struct ShutterShape {
    std::string_view name;   ///< shape as spelled in the header
    Mask2d (*openField)(const DicomDataset&, int columns, int rows);
    std::vector<DicomTag> tags;
};

const std::vector<ShutterShape>& shutterShapes()
{
    static const std::vector<ShutterShape> shapes{
        {"RECTANGULAR", inRectangle, {0x00181602, 0x00181604, 0x00181606, 0x00181608}},
        {"CIRCULAR", inCircle, {0x00181610, 0x00181612}},
        {"POLYGONAL", inPolygon, {verticesTag}}};
    return shapes;
}

std::string shutterValues(const DicomDataset& data, const std::vector<DicomTag>& tags)
{
    std::string values;
    for (const DicomTag tag : tags) {
        values += (values.empty() ? "" : ", ") + std::string(data.text(tag).substr(0, 60));
    }
    return values;
}

/// Closes the area that a shutter hides; skips an implausible shape with a warning.
void close(Mask2d& field, const DicomDataset& shutter, core::Messages& warnings)
{
    const int columns = field.width, rows = field.height;
    for (std::size_t i = 0; i < shutterShapes().size(); ++i) {   // at most one shape of each kind
        const auto shape = std::ranges::find(shutterShapes(), shutter.text(shapeTag, i), &ShutterShape::name);
        if (shape == shutterShapes().end()) {
            continue;
        }
        Mask2d both = shape->openField(shutter, columns, rows);
        std::ranges::transform(both.pixels, field.pixels, both.pixels.begin(), std::bit_and<>());
        if (static_cast<double>(std::ranges::count(both.pixels, 255)) < minOpenShare * columns * rows) {
            warnings.push_back(
                messages::shutterUnusable(std::string(shape->name), shutterValues(shutter, shape->tags)));
        } else {
            field = std::move(both);
        }
    }
}

std::string valuesOf(const DicomDataset& shutter)
{
    std::string values(shutter.text(shapeTag));
    for (const ShutterShape& shape : shutterShapes()) {
        values += "; " + shutterValues(shutter, shape.tags);
    }
    return values;
}

}   // namespace

core::Mask2d shutterMask(const DicomDataset& data, int columns, int rows, core::Messages& warnings)
{
    const DicomDataset first = withFunctionalGroups(data);
    Mask2d field(columns, rows, 255);
    close(field, first, warnings);
    std::set<std::string> closed{valuesOf(first)};
    for (const DicomDataset& frame : data.items(perFrameGroupsTag)) {
        for (const DicomDataset& shutter : frame.items(frameShutterTag)) {
            if (closed.insert(valuesOf(shutter)).second) {
                close(field, shutter, warnings);
            }
        }
    }
    return std::ranges::count(field.pixels, 0) == 0 ? Mask2d() : field;
}

}   // namespace angiopose::io
