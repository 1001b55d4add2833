#include "io/surface_file.h"

#include "core/vessel/stray_points.h"
#include "io/decode/vtk_file.h"
#include "io/messages/messages.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"
#include "io/vessel/stated_coordinates.h"
#include "io/vessel/surface_formats.h"
#include "io/vessel/vtk_lines.h"

#include <algorithm>
#include <cstring>
#include <optional>

namespace angiopose::io {
namespace {

constexpr std::size_t maxTriangles = 50'000'000;
constexpr double minPlausibleMm = 60.0;   // plausible minimum extent of a whole vessel surface
constexpr double maxPlausibleMm = 2000.0;

core::Result<VtkLines> parse(std::string_view content, const std::string& path, const ReadObserver& observe)
{
    const std::string extension = extensionOf(path);
    if (content.starts_with("# vtk DataFile")) {
        return readLegacyVtk(content, path, observe);
    }
    if (content.substr(0, 4096).find("<VTKFile") != std::string_view::npos) {
        return readXmlVtk(content, path, observe);
    }
    if (content.starts_with("ply")) {
        return readPly(path, observe);
    }
    if (extension == ".stl") {
        return parseStl(content, path);
    }
    if (extension == ".obj") {
        return parseObj(content, path);
    }
    const auto* found = describeContent(content);
    if (found == nullptr) {
        return fileError(path, messages::surfaceUnknown());
    }
    return fileError(path, messages::surfaceIsOther((*found)()));
}

/// Returns the problem with the triangles; nullopt if there is none.
std::optional<core::Message> findProblem(const VtkLines& surface)
{
    if (surface.triangles.size() > maxTriangles) {
        return messages::surfaceTooLarge();
    }
    for (const Triangle& triangle : surface.triangles) {
        if (*std::max_element(triangle.begin(), triangle.end()) >= surface.set.points.size()) {
            return messages::surfaceBadIndex();
        }
    }
    return surface.triangles.empty() ? std::optional(messages::surfaceNoTriangles()) : std::nullopt;
}

/// Builds the surface; adds a warning if points were omitted.
core::Result<LoadedSurface> surfaceOf(VtkLines surface, const CoordinateConversion& rule, const std::string& path,
                                      const ReadObserver& observe)
{
    LoadedSurface loaded;
    loaded.warnings = std::move(surface.set.warnings);
    loaded.warnings.insert(loaded.warnings.begin(), rule.notes.begin(), rule.notes.end());
    loaded.isUnitStated = rule.isUnitStated;
    core::SurfaceMesh& mesh = loaded.mesh;
    std::ranges::transform(surface.set.points, std::back_inserter(mesh.pointsInPatient), rule);
    if (const auto problem = findProblem(surface)) {
        return fileError(path, *problem);
    }
    mesh.triangles = std::move(surface.triangles);
    if (const std::size_t stray = core::removeStrayPoints(mesh); stray > 0) {
        loaded.warnings.push_back(
            messages::surfaceStrayPoints(stray, core::Quantity{core::maxBodySizeMm / 1000.0, 1, "m"}));
    }
    const bool isPlausible = std::ranges::all_of(mesh.pointsInPatient, [](const Eigen::Vector3d& point) {
        return point.allFinite() && point.cwiseAbs().maxCoeff() <= 1e6;
    });
    if (!isPlausible) {
        return fileError(path, messages::surfaceCoordinate());
    }
    bool isStopped = false;
    mesh = core::weldPoints(mesh, [&] { return !(isStopped = isStopped || isStopRequested(observe, 1.0)); });
    return isStopped ? core::Result<LoadedSurface>(readingCanceled(path)) : loaded;
}

double acrossMmOf(const core::SurfaceMesh& mesh)
{
    Eigen::Vector3d low = mesh.pointsInPatient.front(), high = low;
    for (const Eigen::Vector3d& point : mesh.pointsInPatient) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    return (high - low).norm();
}

core::Messages checkSurface(const core::SurfaceMesh& mesh, double extentMm)
{
    core::Messages warnings;
    const core::MeshCheck check = core::checkMesh(mesh);
    if (!check.isClosed()) {
        warnings.push_back(messages::surfaceOpen(check.boundaryEdges, check.nonManifoldEdges));
    } else if (!check.isOriented) {
        warnings.push_back(messages::surfaceDisoriented());
    }
    if (!isPlausibleSize(extentMm)) {
        warnings.push_back(messages::surfaceUnusualSize(core::Quantity{extentMm, 1, "mm"}));
    }
    return warnings;
}

}   // namespace

bool isPlausibleSize(double extentMm)
{
    return extentMm >= minPlausibleMm && extentMm <= maxPlausibleMm;
}

core::Result<LoadedSurface> readSurface(const std::string& path, double unitMm, const ReadObserver& observe)
{
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    auto parsed = parse(input.value().view(), path, observe);
    if (!parsed) {
        return parsed.error();
    }
    const auto rule = coordinateConversion(headerText(input.value().view()) + parsed.value().header, unitMm, path);
    if (!rule) {
        return rule.error();
    }
    auto whole = surfaceOf(std::move(parsed).value(), rule.value(), path, observe);
    if (!whole) {
        return whole.error();
    }
    LoadedSurface loaded = std::move(whole).value();
    if (loaded.mesh.triangles.empty()) {
        return fileError(path, messages::surfaceNoArea());
    }
    loaded.extentMm = acrossMmOf(loaded.mesh);
    const core::Messages doubts = checkSurface(loaded.mesh, loaded.extentMm);
    loaded.warnings.insert(loaded.warnings.end(), doubts.begin(), doubts.end());
    return loaded;
}

core::Status writeSurface(const core::SurfaceMesh& mesh, const std::string& path)
{
    if (extensionOf(path) != ".stl") {
        return fileError(path, messages::surfaceExtension());
    }
    std::string content(84 + 50 * mesh.triangles.size(), '\0');
    const std::string title = "binary STL by AngioPose, SPACE=LPS, mm";
    std::copy(title.begin(), title.end(), content.begin());
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    std::memcpy(content.data() + 80, &count, sizeof count);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        char* corners = content.data() + 84 + 50 * i + 12;
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector3f point = mesh.pointsInPatient[mesh.triangles[i][k]].cast<float>();
            std::memcpy(corners + 12 * k, point.data(), 12);
        }
    }
    return writeAtomically(path, content);
}

}   // namespace angiopose::io
