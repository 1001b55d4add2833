#pragma once

#include "core/support/result.h"

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Points and polygons as a file has them; indices are checked later.
struct PolygonSet {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::vector<std::size_t>> polygons;
    bool isRas = false;
};

// Own parsers: none allocates for a count that the rest of the file cannot hold.
core::Result<PolygonSet> parseStl(std::string_view content, const std::string& path);
core::Result<PolygonSet> parsePly(std::string_view content, const std::string& path);
core::Result<PolygonSet> parseObj(std::string_view content, const std::string& path);

/// True for a binary STL file: its length follows from the number of triangles it declares.
bool looksLikeBinaryStl(std::string_view content);

}   // namespace angiopose::io