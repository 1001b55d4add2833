#include "io/opening/input_kind.h"

#include "io/fiducial_file.h"
#include "io/messages/messages.h"
#include "io/pose/opencv_storage.h"
#include "io/pose_camera_file.h"
#include "io/series/slice_record.h"
#include "io/support/input_bytes.h"
#include "io/vessel/tree_table.h"
#include "io/volume_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

constexpr std::streamsize headSize = 4096;
constexpr std::size_t dicomMagicAt = 128;

core::Result<std::string> headOf(const std::string& path)
{
    const std::string name = fs::path(path).filename().string();
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::string head(headSize, '\0');
    if (!file.read(head.data(), headSize) && !file.eof()) {
        return core::Error(messages::openUnreadable(name, std::generic_category().message(errno)));
    }
    head.resize(static_cast<std::size_t>(file.gcount()));
    return head.empty() ? core::Result<std::string>(core::Error(messages::openEmpty(name))) : head;
}

bool startsAsDicom(std::string_view head)
{
    return head.size() > dicomMagicAt && head.substr(dicomMagicAt).starts_with("DICM");
}

constexpr std::string_view spatialRegistration = "1.2.840.10008.5.1.4.1.1.66.1";

/// Distinguishes JSON files with curves, fiducials and poses.
InputKind kindOfJson(const std::string& path, std::string_view head)
{
    if (head.find("\"markups\"") != std::string_view::npos) {
        return isFiducialFile(path) ? InputKind::Points : InputKind::Centerline;
    }
    const bool isPose = head.find("cameraFromPatient") != std::string_view::npos || readPoseWithCamera(path);
    return isPose ? InputKind::Pose : InputKind::Centerline;   // the reader reports what is wrong with the file
}

/// Returns the kind of a DICOM file: an image for X-ray runs; a volume for anything with a position in the patient.
InputKind kindOfDicom(const std::string& path, std::string_view head)
{
    if (head.find(spatialRegistration) != std::string_view::npos) {
        return InputKind::Pose;
    }
    const auto images = readSliceRecords(path);
    if (!images || images.value().slices.empty()) {
        return InputKind::Image;   // the reader reports what is wrong with the file
    }
    const bool isSlice = !images.value().isProjection && images.value().slices.front().position;
    return isSlice ? InputKind::Vessels : InputKind::Image;
}

bool startsAsPicture(std::string_view head)
{
    using namespace std::string_view_literals;
    return head.starts_with("\x89PNG") || head.starts_with("\xFF\xD8\xFF") || head.starts_with("II*\0"sv) ||
           head.starts_with("MM\0*"sv);
}

bool startsAsVtk(std::string_view head)
{
    return head.starts_with("# vtk DataFile") || head.find("<VTKFile") != std::string_view::npos;
}

template <std::size_t N>
bool isOneOf(const std::array<std::string_view, N>& extensions, std::string_view extension)
{
    return std::ranges::find(extensions, extension) != extensions.end();
}

core::Result<InputKind> kindByName(const std::string& path, std::string_view head)
{
    static constexpr std::array<std::string_view, 8> images{".png",  ".tif", ".tiff",  ".jpg",
                                                            ".jpeg", ".dcm", ".dicom", ".ima"};
    static constexpr std::array<std::string_view, 4> centerlines{".vtp", ".vtk", ".vtu", ".swc"};
    static constexpr std::array<std::string_view, 6> poses{".tfm", ".mat", ".h5", ".yml", ".yaml", ".xml"};
    static constexpr std::array<std::string_view, 3> surfaces{".stl", ".ply", ".obj"};
    const std::string extension = extensionOf(path);
    if (extension == ".csv") {
        return isTreeTable(head) ? InputKind::Centerline : InputKind::Target;
    }
    if (extension == ".json") {
        return kindOfJson(path, head);
    }
    if (isOneOf(poses, extension) || (extension == ".txt" && !parseNumbers(head).empty())) {
        return InputKind::Pose;
    }
    if (extension == ".fcsv") {
        return InputKind::Points;
    }
    if (isOneOf(centerlines, extension)) {
        return InputKind::Centerline;
    }
    if (isOneOf(surfaces, extension)) {
        return InputKind::Vessels;
    }
    if (isOneOf(images, extension)) {
        return InputKind::Image;
    }
    return core::Error(messages::openUnknown(fs::path(path).filename().string()));
}

}   // namespace

core::Result<InputKind> inputKindOf(const std::string& path)
{
    std::error_code failure;
    const fs::file_status status = fs::status(path, failure);
    if (!fs::exists(status)) {
        return core::Error(messages::openMissing(path));
    }
    if (fs::is_directory(status)) {
        return InputKind::Folder;
    }
    if (!fs::is_regular_file(status)) {
        return core::Error(messages::fileNotRegular().about(path));
    }
    const auto head = headOf(path);
    if (!head) {
        return head.error();
    }
    // A case file is recognized by its extension; reading validates its content.
    if (extensionOf(path) == ".angiopose") {
        return InputKind::Case;
    }
    if (startsAsDicom(head.value())) {
        return kindOfDicom(path, head.value());
    }
    if (startsAsPicture(head.value())) {
        return InputKind::Image;
    }
    if (isVolumeFile(path)) {
        return InputKind::Vessels;
    }
    if (startsAsVtk(head.value())) {
        return InputKind::Centerline;
    }
    return kindByName(path, head.value());
}

}   // namespace angiopose::io
