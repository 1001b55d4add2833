#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/value_cursor.h"
#include "io/surface/surface_formats.h"

#include <optional>

namespace angiopose::io {
namespace {

struct Property {
    std::string name;
    const NumberType* type = nullptr;
    const NumberType* countType = nullptr;   ///< of a list; else null
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};

/// "float x" or "list uchar int vertex_indices"; nothing when it is damaged.
std::optional<Property> propertyOf(ValueCursor words)
{
    Property property;
    const bool isList = words.peekWord() == "list";
    if (isList) {
        words.word();
        property.countType = numberTypeOf(words.word());
    }
    property.type = numberTypeOf(words.word());
    property.name = words.word();
    const bool isSound = property.type && (property.countType || !isList) && !property.name.empty();
    return isSound ? std::optional(property) : std::nullopt;
}

/// Reads up to the first value, whose coding the cursor then has; nothing when the header is damaged.
std::optional<std::vector<Element>> readHeader(ValueCursor& cursor)
{
    std::vector<Element> elements;
    Coding coding = Coding::Text;
    while (cursor.left() > 0) {
        ValueCursor words(cursor.line());
        const std::string_view kind = words.word();
        if (kind == "end_header") {
            cursor.setCoding(coding);
            return elements;
        }
        if (kind == "format") {
            const std::string_view format = words.word();
            coding = format == "ascii"                  ? Coding::Text
                     : format == "binary_little_endian" ? Coding::LittleEndian
                                                        : Coding::BigEndian;
        } else if (kind == "element") {
            const std::string_view name = words.word();
            const auto count = words.count();
            if (!count) {
                return std::nullopt;
            }
            elements.push_back({std::string(name), *count, {}});
        } else if (kind == "property") {
            const auto property = propertyOf(words);
            if (!property || elements.empty()) {
                return std::nullopt;
            }
            elements.back().properties.push_back(*property);
        }
    }
    return std::nullopt;
}

/// Numbers of one property: one, or a list.
bool takeValues(ValueCursor& body, const Property& property, std::vector<double>& values)
{
    std::size_t count = 1;
    if (property.countType) {
        const auto given = body.number(*property.countType);
        if (!given || !(*given >= 0.0) || *given > static_cast<double>(body.left())) {
            return false;
        }
        count = static_cast<std::size_t>(*given);
    }
    values.clear();
    for (std::size_t i = 0; i < count; ++i) {
        const auto value = body.number(*property.type);
        if (!value) {
            return false;
        }
        values.push_back(*value);
    }
    return true;
}

bool readEntry(ValueCursor& body, const Element& element, PolygonSet& set)
{
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    std::vector<double> values;
    for (const Property& property : element.properties) {
        if (!takeValues(body, property, values)) {
            return false;
        }
        const bool isList = property.countType != nullptr;
        if (element.name == "vertex" && !isList && property.name.size() == 1 && property.name[0] >= 'x' &&
            property.name[0] <= 'z') {
            point[property.name[0] - 'x'] = values[0];
        }
        if (element.name == "face" && isList && property.name.starts_with("vertex_ind")) {
            std::vector<std::size_t>& polygon = set.polygons.emplace_back();
            polygon.reserve(values.size());
            for (const double value : values) {
                polygon.push_back(value >= 0.0 && value < 4e9 ? static_cast<std::size_t>(value) : std::size_t(-1));
            }
        }
    }
    if (element.name == "vertex") {
        set.points.push_back(point);
    }
    return true;
}

}   // namespace

core::Result<PolygonSet> parsePly(std::string_view content, const std::string& path)
{
    ValueCursor cursor(content);
    const auto elements = readHeader(cursor);
    if (!elements) {
        return fileError(path, says::plyHeaderDamaged());
    }
    PolygonSet set;
    for (const Element& element : *elements) {
        if (element.properties.empty() && element.count > 0) {
            return fileError(path, says::plyElementEmpty(element.name.substr(0, 24)));
        }
        for (std::size_t i = 0; i < element.count; ++i) {
            if (!readEntry(cursor, element, set)) {
                return fileError(path, says::plyDataDamaged());
            }
        }
    }
    return set;
}

}   // namespace angiopose::io
