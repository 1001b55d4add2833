#include "io/vessel/vtk_lines.h"

#include <algorithm>
#include <array>
#include <cmath>

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