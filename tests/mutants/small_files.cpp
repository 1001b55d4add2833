#include "tests/mutants/small_files.h"

#include "io/angiogram_file.h"
#include "io/image_file.h"
#include "io/pose_file.h"
#include "io/surface_file.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"
#include "tests/io/study/study_disc.h"
#include "tests/support/temporary_folder.h"

#include <array>

namespace angiopose::test {
namespace {

core::VesselTree smallTree()
{
    core::VesselTree tree;
    core::VesselBranch branch{7, "branch", {}, {}};
    for (int i = 0; i < 12; ++i) {
        branch.pointsInPatient.emplace_back(i, 0.1 * i * i, 100.0 - i);
        branch.radiusMm.push_back(1.0 + 0.1 * i);
    }
    tree.branches.push_back(branch);
    return tree;
}

core::Volume smallVolume()
{
    core::VolumeGeometry geometry;
    geometry.size = {9, 8, 7};
    core::Volume volume(geometry);
    for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
        volume.voxels[i] = static_cast<std::int16_t>(37 * i % 2000);
    }
    return volume;
}

core::Angiogram smallRun()
{
    core::Angiogram angiogram;
    angiogram.frames.assign(2, core::ImageF(24, 18, 100.0F));
    angiogram.frames[1].at(3, 4) = 700.0F;
    angiogram.frameTimeMs = 66.0;
    angiogram.cArm.sourceToDetectorMm = {1000.0, core::Origin::Header, ""};
    return angiogram;
}

/// A box around the tree: eight points, twelve triangles.
core::SurfaceMesh smallSurface()
{
    core::SurfaceMesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        mesh.pointsInPatient.emplace_back(corner % 2 * 60.0, corner / 2 % 2 * 8.0, corner / 4 * 8.0);
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

std::string objText(const core::SurfaceMesh& mesh)
{
    std::string text;
    for (const Eigen::Vector3d& point : mesh.pointsInPatient) {
        text += "v " + std::to_string(point.x()) + " " + std::to_string(point.y()) + " " + std::to_string(point.z());
        text += "\n";
    }
    for (const auto& triangle : mesh.triangles) {
        text += "f";
        for (const std::uint32_t index : triangle) {
            text += " " + std::to_string(index + 1);
        }
        text += "\n";
    }
    return text;
}

std::string plyText(const core::SurfaceMesh& mesh)
{
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 12\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Eigen::Vector3d& point : mesh.pointsInPatient) {
        text += std::to_string(point.x()) + " " + std::to_string(point.y()) + " " + std::to_string(point.z()) + "\n";
    }
    for (const auto& triangle : mesh.triangles) {
        text += "3";
        for (const std::uint32_t index : triangle) {
            text += " " + std::to_string(index);
        }
        text += "\n";
    }
    return text;
}

/// A pose as written by ITK for MATLAB, level 4.
std::string matlabPose()
{
    const auto matrix = [](const std::string& name, const std::vector<double>& values) {
        const std::array<std::uint32_t, 5> head{0, static_cast<std::uint32_t>(values.size()), 1, 0,
                                                static_cast<std::uint32_t>(name.size() + 1)};
        return std::string(reinterpret_cast<const char*>(head.data()), sizeof head) + name + '\0' +
               std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
    };
    return matrix("Euler3DTransform_double_3_3", {0.1, -0.2, 0.3, 1.5, -2, 740.25}) + matrix("fixed", {10, 20, 30, 0});
}

constexpr const char* legacyText =
    "# vtk DataFile Version 3.0\nlines\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 2 0 1 3 1 1\n"
    "LINES 1 5\n4 0 1 2 3\nPOINT_DATA 4\nSCALARS Radius float 1\nLOOKUP_TABLE default\n1 1 2 2\n"
    "CELL_DATA 1\nFIELD FieldData 1\nGroupIds 1 1 int\n7\n";

constexpr const char* gridText =
    "# vtk DataFile Version 2.0\ngrid\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n0 0 0 5 0 0 9 1 0\n"
    "CELLS 2 6\n2 0 1\n2 1 2\nCELL_TYPES 2\n3\n3\nPOINT_DATA 3\nSCALARS Radius double 1\nLOOKUP_TABLE default\n1 1 1\n";

}   // namespace

std::vector<SmallFile> smallFiles(const std::string& dataFolder, const TemporaryFolder& scratch)
{
    std::vector<SmallFile> files;
    const auto written = [&](const std::string& name, const auto& write) {
        const std::string path = scratch.file(name);
        if (write(path)) {
            files.push_back({name, readText(path)});
        }
    };
    for (const char* name : {"raw.nii", "packed.nrrd", "packed.mha"}) {
        written(name, [](const std::string& path) { return io::writeVolume(smallVolume(), path); });
    }
    files.push_back({"packed.nii.gz", files.front().content, true});
    written("run.dcm", [](const std::string& path) { return io::writeAngiogram(smallRun(), path); });
    written("mask.png", [](const std::string& path) { return io::writePng(core::Mask2d(40, 30), path); });
    for (const char* name : {"tree.vtp", "tree.csv", "tree.swc", "tree.mrk.json"}) {
        written(name, [](const std::string& path) { return io::writeVesselTree(smallTree(), path); });
    }
    for (const char* name : {"pose.tfm", "pose.h5"}) {
        written(name, [](const std::string& path) { return io::writePose({}, path); });
    }
    files.push_back({"pose.mat", matlabPose()});
    files.push_back({"lines.vtk", legacyText});
    files.push_back({"grid.vtk", gridText});
    written("box.stl", [](const std::string& path) { return io::writeSurface(smallSurface(), path); });
    files.push_back({"box.ply", plyText(smallSurface())});
    files.push_back({"box.obj", objText(smallSurface())});
    for (std::size_t i = files.size() - 3; i < files.size(); ++i) {
        files[i].isSurface = true;
    }
    writeDicomdir(scratch.file(""), writeDisc(scratch));
    files.push_back({"DICOMDIR", readText(scratch.file("DICOMDIR")), false, false, true});
    constexpr std::array real = {
        std::pair("jpeg.dcm", "exotic-dicom/pydicom/JPEG-lossy.dcm"),
        std::pair("jpeg2000.dcm", "exotic-dicom/pydicom/MR_small_jp2klossless.dcm"),
        std::pair("jpegls.dcm", "exotic-dicom/pydicom/MR_small_jpeg_ls_lossless.dcm"),
        std::pair("rle.dcm", "exotic-dicom/pydicom/MR_small_RLE.dcm"),
        std::pair("implicit.dcm", "exotic-dicom/pydicom/MR_small_implicit.dcm"),
        std::pair("enhanced.dcm", "exotic-dicom/pydicom-data/emri_small.dcm"),
        std::pair("dsa.jpg", "cerebral-dsa-frame/Real-DSA-01.jpg"),
        std::pair("pages.tiff", "thinning-reference/itkthickness3d_input.tiff"),
        std::pair("soup.stl", "exotic-mesh/soup.stl"),
    };
    for (const auto& [name, path] : real) {
        if (std::filesystem::exists(std::filesystem::path(dataFolder) / path)) {
            files.push_back({name, readText(std::filesystem::path(dataFolder) / path)});
        }
    }
    return files;
}

}   // namespace angiopose::test
