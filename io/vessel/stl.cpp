#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/support/text_cursor.h"
#include "io/vessel/surface_formats.h"

#include <cstdint>
#include <cstring>
#include <optional>

namespace angiopose::io {
namespace {

constexpr std::size_t headSize = 84;
constexpr std::size_t triangleSize = 50;

std::uint32_t declaredTriangles(std::string_view content)
{
    std::uint32_t count = 0;
    std::memcpy(&count, content.data() + 80, sizeof count);
    return count;
}

/// Returns the number of triangles that fit into the content.
std::size_t heldTriangles(std::string_view content)
{
    return (content.size() - headSize) / triangleSize;
}

/// Returns whether the content is ASCII STL. Binary files may also start with "solid" but contain null bytes.
bool isText(std::string_view content)
{
    const std::string head = toLower(content.substr(0, 512));
    return head.find("solid") != std::string::npos && head.find('\0') == std::string::npos;
}

VtkLines parseBinary(std::string_view content)
{
    VtkLines surface;
    const std::uint32_t count = declaredTriangles(content);
    for (std::uint32_t i = 0; i < count; ++i) {
        const char* corners = content.data() + headSize + std::size_t{i} * triangleSize + 12;   // skip the normal
        for (std::size_t k = 0; k < 3; ++k) {
            float point[3];
            std::memcpy(point, corners + 12 * k, sizeof point);
            surface.set.points.emplace_back(point[0], point[1], point[2]);
        }
        surface.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return surface;
}

/// Parses all lines "vertex x y z"; every three vertices form a triangle. Returns nullopt if a vertex is damaged.
std::optional<VtkLines> parseText(std::string_view content)
{
    VtkLines surface;
    bool hasEnd = false;
    for (TextReader cursor(content); !cursor.isAtEnd();) {
        const std::string word = toLower(cursor.word());
        hasEnd = word == "endsolid" || (hasEnd && word != "solid" && word != "facet");
        if (word != "vertex") {
            continue;
        }
        const auto point = cursor.point();
        if (!point) {
            return std::nullopt;
        }
        surface.set.points.push_back(*point);
        const auto count = static_cast<std::uint32_t>(surface.set.points.size());
        if (count % 3 == 0) {
            surface.triangles.push_back({count - 3, count - 2, count - 1});
        }
    }
    if (!hasEnd) {
        surface.set.warnings.push_back(messages::stlWithoutEnd(surface.triangles.size()));
    }
    return surface.set.points.size() % 3 == 0 ? std::optional(std::move(surface)) : std::nullopt;
}

}   // namespace

bool looksLikeBinaryStl(std::string_view content)
{
    return content.size() >= headSize && !isText(content) && heldTriangles(content) >= declaredTriangles(content);
}

core::Result<VtkLines> parseStl(std::string_view content, const std::string& path)
{
    if (isText(content)) {
        auto surface = parseText(content);
        return surface ? core::Result<VtkLines>(std::move(*surface)) : fileError(path, messages::surfaceCutShort());
    }
    if (content.size() < headSize) {
        return fileError(path, messages::surfaceCutShort());
    }
    const std::size_t declared = declaredTriangles(content), held = heldTriangles(content);
    if (declared > held || (declared == 0 && held > 0)) {
        return fileError(path, messages::stlTooFew(declared, held));
    }
    VtkLines surface = parseBinary(content);
    if (held > declared) {
        surface.set.warnings.push_back(messages::stlTooMany(declared, held));
    }
    return surface;
}

}   // namespace angiopose::io
