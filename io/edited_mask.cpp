#include "io/edited_mask.h"

#include "io/file_hash.h"
#include "io/support/atomic_file.h"
#include "io/support/companion_path.h"
#include "io/support/input_bytes.h"
#include "io/volume_file.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Returns the mask file that the case file on disk names; empty if it names none.
fs::path ownMask(const fs::path& casePath)
{
    const auto input = openInput(casePath.string());
    const Json root = input ? Json::parse(input.value().view(), nullptr, false) : Json();
    const Json vessel = root.is_object() ? root.value("vessel", Json::object()) : Json::object();
    const Json mask = vessel.is_object() ? vessel.value("segmentation", Json()) : Json();
    if (!mask.is_object() || mask.value("origin", "") != "edited") {
        return {};
    }
    return (casePath.parent_path() / mask.value("path", "")).lexically_normal();
}

/// Returns whether the case's own file still contains this mask; after an undo, a later save may have overwritten it.
bool isUpToDate(const core::InputFile& mask, const fs::path& own)
{
    if (mask.path.empty() || mask.path != own.string()) {
        return false;
    }
    const auto hash = sha256OfFile(mask.path);
    return hash && hash.value() == mask.sha256;
}

/// Copies a mask file that could not be read, unchanged.
core::Status copied(const std::string& from, const std::string& to)
{
    const auto content = openInput(from);
    return content ? writeAtomically(to, content.value().view()) : core::Status(content.error());
}

}   // namespace

core::Status writeMask(const core::VoxelMask& mask, const std::string& path)
{
    core::LabelVolume labels(mask.geometry);
    std::ranges::transform(mask.voxels, labels.voxels.begin(),
                           [](std::uint8_t voxel) { return static_cast<std::uint16_t>(voxel != 0 ? 1 : 0); });
    return writeLabels(labels, path);
}

core::Result<core::InputFile> saveEditedMask(const core::Vessels& vessels, const std::string& casePath)
{
    const fs::path whole = fs::absolute(casePath);
    const fs::path own = ownMask(whole);
    if (isUpToDate(vessels.file, own)) {
        return vessels.file;
    }
    std::error_code absent;
    if (!vessels.lumen && !fs::exists(vessels.file.path, absent)) {
        return vessels.file;   // the file no longer exists: keep its former path in the case
    }
    const std::string path = companionPath(whole, {{}, "mask", "nrrd"}, vessels.lumen ? own : fs::path()).string();
    if (const auto written = vessels.lumen ? writeMask(*vessels.lumen, path) : copied(vessels.file.path, path);
        !written) {
        return written.error();
    }
    auto hash = sha256OfFile(path);
    return hash ? core::Result<core::InputFile>(core::InputFile{path, std::move(hash).value()}) : hash.error();
}

}   // namespace angiopose::io
