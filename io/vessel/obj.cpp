#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/support/text_cursor.h"
#include "io/vessel/surface_formats.h"

namespace angiopose::io {
namespace {

/// Returns the point index of a face vertex: "12/3/4" is point 12, starting at 1, and "-1" the last point so far. An
/// invalid index is detected later.
std::size_t pointIndex(std::string_view word, std::size_t pointCount)
{
    const int index = parseInteger(word.substr(0, word.find('/'))).value_or(0);
    return static_cast<std::size_t>(index < 0 ? static_cast<long>(pointCount) + index : static_cast<long>(index) - 1);
}

}   // namespace

core::Result<VtkLines> parseObj(std::string_view content, const std::string& path)
{
    VtkLines surface;
    std::vector<Eigen::Vector3d>& points = surface.set.points;
    TextReader lines(content);
    for (std::size_t line = 1; lines.left() > 0; ++line) {
        TextReader words(lines.line());
        const std::string_view kind = words.word();
        if (kind == "v") {
            const auto point = words.point();
            if (!point) {
                return fileError(path, messages::objBadPoint(line));
            }
            points.push_back(*point);
        } else if (kind == "f") {
            std::vector<std::size_t> polygon;
            while (!words.isAtEnd()) {
                polygon.push_back(pointIndex(words.word(), points.size()));
            }
            addTriangleFan(polygon, surface.triangles);
        }
    }
    return surface;
}

}   // namespace angiopose::io
