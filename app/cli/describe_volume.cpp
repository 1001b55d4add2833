#include "app/cli/describe_volume.h"

#include "app/cli/add_warnings.h"
#include "io/dicom_series.h"
#include "io/label_list.h"
#include "io/series/dicom_segmentation.h"
#include "io/surface_file.h"
#include "io/volume_file.h"

#include <cmath>
#include <numbers>

namespace angiopose::app {
namespace {

using Json = nlohmann::ordered_json;

template <class Vector>
Json listOf(const Vector& vector)
{
    Json list = Json::array();
    for (int i = 0; i < static_cast<int>(vector.size()); ++i) {
        list.push_back(vector[i]);
    }
    return list;
}

/// Describes the anatomical direction of an axis, e.g. "left" or "head, 12° oblique".
std::string directionText(const Eigen::Vector3d& direction)
{
    constexpr const char* names[3][2] = {{"right", "left"}, {"front", "back"}, {"feet", "head"}};
    Eigen::Index axis = 0;
    const double along = direction.cwiseAbs().maxCoeff(&axis);
    const double obliqueDeg = std::acos(std::min(1.0, along)) * 180.0 / std::numbers::pi;
    const std::string name = names[axis][direction[axis] > 0.0 ? 1 : 0];
    return obliqueDeg < 0.5 ? name : name + ", " + std::to_string(std::lround(obliqueDeg)) + "° oblique";
}

Json gridJson(const core::VolumeGeometry& geometry)
{
    const Eigen::Vector3d extent = geometry.size.cast<double>().cwiseProduct(geometry.spacingMm);
    const Eigen::Vector3d center = geometry.patientFromVoxel() * (0.5 * (geometry.size.cast<double>().array() - 1.0));
    return {
        {"size", listOf(geometry.size)},
        {"spacingMm", listOf(geometry.spacingMm)},
        {"extentMm", listOf(extent)},
        {"originInPatientMm", listOf(geometry.originInPatient)},
        {"centreInPatientMm", listOf(center)},
        {"axesRunTo", Json::array({directionText(geometry.direction.col(0)), directionText(geometry.direction.col(1)),
                                   directionText(geometry.direction.col(2))})},
        {"memoryMiB", static_cast<double>(geometry.voxelCount()) * 2.0 / 1048576.0}};
}

Json seriesJson(const io::DicomSeries& series)
{
    Json json{{"kind", series.isAngiogram ? "angiogram" : "volume"},
              {"seriesId", series.id},
              {"description", series.description},
              {"modality", series.identity.modality},
              {"number", series.number},
              {"studyDate", series.identity.studyDate},
              {"images", series.slices.size()}};
    if (series.part) {
        json["part"] = series.part->text();
    }
    if (series.isAngiogram) {
        json["file"] = series.slices.front().path;
    } else if (!series.problem) {
        json["geometry"] = gridJson(series.stack.geometry);
    }
    if (series.problem) {
        json["problem"] = series.problem->text();
    }
    addWarnings(json, series.warnings);
    return json;
}

Json labelsJson(const std::vector<io::LabelInfo>& labels)
{
    Json list = Json::array();
    for (const io::LabelInfo& listedLabel : labels) {
        Json json{{"label", listedLabel.label}};
        if (!listedLabel.name.empty()) {
            json["name"] = listedLabel.name;
        }
        json["voxels"] = listedLabel.voxels;
        json["volumeMl"] = listedLabel.volumeMl;
        list.push_back(std::move(json));
    }
    return list;
}

}   // namespace

core::Result<Json> folderJson(const std::string& path)
{
    const auto all = io::listSeries(path);
    if (!all) {
        return all.error();
    }
    Json list = Json::array();
    for (const io::DicomSeries& series : all.value()) {
        list.push_back(seriesJson(series));
    }
    return Json{{"kind", "DICOM folder"}, {"series", std::move(list)}};
}

core::Result<Json> volumeJson(const std::string& path)
{
    const auto summary = io::describeVolume(path);
    if (!summary) {
        return summary.error();
    }
    const io::VolumeSummary& volume = summary.value();
    Json json{{"kind", "volume"},      {"format", volume.format},       {"voxelType", volume.voxelType},
              {"slope", volume.slope}, {"intercept", volume.intercept}, {"geometry", gridJson(volume.geometry)}};
    if (const auto labels = io::listLabelsOfFile(path)) {
        json["kind"] = "label image";
        json["labels"] = labelsJson(*labels);
    }
    addWarnings(json, volume.warnings);
    return json;
}

core::Result<Json> dicomVolumeJson(const std::string& path)
{
    const auto series = io::seriesOfFile(path);
    return series ? core::Result<Json>(seriesJson(series.value())) : series.error();
}

core::Result<Json> segmentationJson(const std::string& path)
{
    const auto labels = io::readDicomSegmentation(path);
    if (!labels) {
        return labels.error();
    }
    return Json{{"kind", "segmentation"},
                {"format", "DICOM segmentation"},
                {"labels", labelsJson(io::listLabels(labels.value(), io::readLabelNames(path)))},
                {"geometry", gridJson(labels.value().geometry)}};
}

core::Result<Json> surfaceJson(const std::string& path)
{
    const auto surface = io::readSurface(path);
    if (!surface) {
        return surface.error();
    }
    const core::SurfaceMesh& mesh = surface.value().mesh;
    const core::MeshCheck check = core::checkMesh(mesh);
    Eigen::Vector3d low = mesh.pointsInPatient.front(), high = low;
    for (const Eigen::Vector3d& point : mesh.pointsInPatient) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    Json json{{"kind", "surface"},
              {"points", mesh.pointsInPatient.size()},
              {"triangles", mesh.triangles.size()},
              {"isClosed", check.isClosed()},
              {"isOriented", check.isOriented},
              {"lowestCornerInPatientMm", listOf(low)},
              {"extentMm", listOf(Eigen::Vector3d(high - low))}};
    addWarnings(json, surface.value().warnings);
    return json;
}

}   // namespace angiopose::app
