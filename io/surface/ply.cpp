#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/surface/surface_formats.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <sstream>

namespace angiopose::io {
namespace {

enum class Coding { Text, LittleEndian, BigEndian };

struct Property {
    std::string name;
    std::string type;
    std::string countType;   ///< of a list; else empty
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};

struct PlyHeader {
    Coding coding = Coding::Text;
    std::vector<Element> elements;
    std::size_t size = 0;
};

std::size_t bytesOf(std::string_view type)
{
    if (type == "char" || type == "uchar" || type == "int8" || type == "uint8") {
        return 1;
    }
    if (type == "short" || type == "ushort" || type == "int16" || type == "uint16") {
        return 2;
    }
    if (type == "double" || type == "float64") {
        return 8;
    }
    const bool isFour =
        type == "int" || type == "uint" || type == "int32" || type == "uint32" || type == "float" || type == "float32";
    return isFour ? 4 : 0;
}

bool readProperty(std::istringstream& words, Element& element)
{
    Property property;
    words >> property.type;
    if (property.type == "list") {
        words >> property.countType >> property.type;
        if (bytesOf(property.countType) == 0) {
            return false;
        }
    }
    words >> property.name;
    element.properties.push_back(property);
    return bytesOf(property.type) > 0 && !property.name.empty();
}

std::optional<PlyHeader> headerOf(std::string_view content)
{
    PlyHeader header;
    for (std::size_t at = 0; at < content.size();) {
        const std::size_t newline = content.find('\n', at);
        if (newline == std::string_view::npos) {
            return std::nullopt;
        }
        std::istringstream words{std::string(trimmed(content.substr(at, newline - at)))};
        at = newline + 1;
        std::string word;
        words >> word;
        if (word == "end_header") {
            header.size = at;
            return header;
        }
        if (word == "format") {
            words >> word;
            header.coding = word == "ascii"                  ? Coding::Text
                            : word == "binary_little_endian" ? Coding::LittleEndian
                                                             : Coding::BigEndian;
        } else if (word == "element") {
            Element element;
            if (!(words >> element.name >> element.count)) {
                return std::nullopt;
            }
            header.elements.push_back(element);
        } else if (word == "property" && (header.elements.empty() || !readProperty(words, header.elements.back()))) {
            return std::nullopt;
        }
    }
    return std::nullopt;
}

/// Takes one number after the other off the body, whatever its coding.
class PlyBody {
public:
    PlyBody(std::string_view rest, Coding coding) : rest_(rest), coding_(coding) {}

    std::size_t left() const { return rest_.size(); }

    std::optional<double> take(const std::string& type)
    {
        return coding_ == Coding::Text ? takeText() : takeBinary(type);
    }

private:
    std::optional<double> takeText()
    {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
        const std::size_t end = std::min(rest_.find_first_of(" \t\r\n"), rest_.size());
        const auto number = parseNumber(rest_.substr(0, end));
        rest_.remove_prefix(end);
        return number;
    }

    template <class T>
    double as(std::array<char, 8> bytes) const
    {
        T value;
        std::memcpy(&value, bytes.data(), sizeof value);
        return static_cast<double>(value);
    }

    std::optional<double> takeBinary(const std::string& type)
    {
        const std::size_t size = bytesOf(type);
        if (rest_.size() < size) {
            return std::nullopt;
        }
        std::array<char, 8> bytes{};
        std::copy_n(rest_.data(), size, bytes.begin());
        if (coding_ == Coding::BigEndian) {
            std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        }
        rest_.remove_prefix(size);
        if (size == 8) {
            return as<double>(bytes);
        }
        if (type.starts_with("float")) {
            return as<float>(bytes);
        }
        const bool isUnsigned = type.starts_with("u");
        if (size == 4) {
            return isUnsigned ? as<std::uint32_t>(bytes) : as<std::int32_t>(bytes);
        }
        if (size == 2) {
            return isUnsigned ? as<std::uint16_t>(bytes) : as<std::int16_t>(bytes);
        }
        return isUnsigned ? as<std::uint8_t>(bytes) : as<std::int8_t>(bytes);
    }

    std::string_view rest_;
    Coding coding_;
};

/// Numbers of one property: one, or a list.
bool takeValues(PlyBody& body, const Property& property, std::vector<double>& values)
{
    std::size_t count = 1;
    if (!property.countType.empty()) {
        const auto given = body.take(property.countType);
        if (!given || !(*given >= 0.0) || *given > static_cast<double>(body.left())) {
            return false;
        }
        count = static_cast<std::size_t>(*given);
    }
    values.clear();
    for (std::size_t i = 0; i < count; ++i) {
        const auto value = body.take(property.type);
        if (!value) {
            return false;
        }
        values.push_back(*value);
    }
    return true;
}

bool readEntry(PlyBody& body, const Element& element, PolygonSet& set)
{
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    std::vector<double> values;
    for (const Property& property : element.properties) {
        if (!takeValues(body, property, values)) {
            return false;
        }
        const bool isList = !property.countType.empty();
        if (element.name == "vertex" && !isList && property.name.size() == 1 && property.name[0] >= 'x' &&
            property.name[0] <= 'z') {
            point[property.name[0] - 'x'] = values[0];
        }
        if (element.name == "face" && isList && property.name.starts_with("vertex_ind")) {
            std::vector<std::size_t> polygon;
            polygon.reserve(values.size());
            for (const double value : values) {
                polygon.push_back(value >= 0.0 && value < 4e9 ? static_cast<std::size_t>(value) : std::size_t(-1));
            }
            set.polygons.push_back(std::move(polygon));
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
    const auto header = headerOf(content);
    if (!header) {
        return fileError(path, says::plyHeaderDamaged());
    }
    PolygonSet set;
    PlyBody body(content.substr(header->size), header->coding);
    for (const Element& element : header->elements) {
        if (element.properties.empty() && element.count > 0) {
            return fileError(path, says::plyElementEmpty(element.name.substr(0, 24)));
        }
        for (std::size_t i = 0; i < element.count; ++i) {
            if (!readEntry(body, element, set)) {
                return fileError(path, says::plyDataDamaged());
            }
        }
    }
    return set;
}

}   // namespace angiopose::io