#include "io/vessel/vtk_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace angiopose::io {
namespace {

constexpr std::array radiusNames = {"Radius", "MaximumInscribedSphereRadius", "radius"};
constexpr std::array idNames = {"GroupIds", "CenterlineIds", "BranchId", "branch"};

template <std::size_t Count>
const std::vector<double>* findArray(const std::map<std::string, std::vector<double>>& arrays,
                                     const std::array<const char*, Count>& names)
{
    for (const char* name : names) {
        const auto found = arrays.find(name);
        if (found != arrays.end()) {
            return &found->second;
        }
    }
    return nullptr;
}

}   // namespace

void addTriangleFan(const std::vector<std::size_t>& corners, std::vector<Triangle>& triangles)
{
    const auto index = [&corners](std::size_t k) {
        return static_cast<std::uint32_t>(std::min<std::size_t>(corners[k], std::numeric_limits<std::uint32_t>::max()));
    };
    for (std::size_t k = 2; k < corners.size(); ++k) {
        triangles.push_back({index(0), index(k - 1), index(k)});
    }
}

LineSet lineSetOf(VtkLines lines)
{
    LineSet set = std::move(lines.set);
    const auto* radius = findArray(lines.pointArrays, radiusNames);
    if (radius && radius->size() == set.points.size()) {
        set.radius = *radius;
    }
    const auto* ids = findArray(lines.cellArrays, idNames);
    for (const std::size_t cell : lines.cellOfLine) {
        if (ids && cell < ids->size() && std::abs((*ids)[cell]) < 1e9) {
            set.ids.push_back(static_cast<int>((*ids)[cell]));
        }
        if (cell < lines.cellNames.size()) {
            set.names.push_back(lines.cellNames[cell]);
        }
    }
    if (set.ids.size() != set.lines.size()) {
        set.ids.clear();
    }
    if (set.names.size() != set.lines.size()) {
        set.names.clear();
    }
    return set;
}

}   // namespace angiopose::io
