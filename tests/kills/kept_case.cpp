#include "tests/kills/kept_case.h"

#include "io/angiogram_file.h"
#include "io/case/case_file.h"
#include "io/case/overwrite_case.h"
#include "io/image_file.h"
#include "io/pose_file.h"
#include "io/support/case_lock.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"
#include "tests/support/temporary_folder.h"

#include <cstdio>
#include <cstdlib>

namespace angiopose::test {
namespace {

namespace fs = std::filesystem;

core::ColorImage pictureOf(int number)
{
    core::ColorImage picture{400, 300, std::vector<std::uint8_t>(400 * 300 * 3)};
    for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
        picture.rgb[i] = static_cast<std::uint8_t>(i * i * static_cast<std::size_t>(number + 7) >> 5U);
    }
    return picture;
}

core::Volume volumeOf(int number)
{
    core::VolumeGeometry geometry;
    geometry.size = {48, 48, 48};
    core::Volume volume(geometry);
    for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
        volume.voxels[i] = static_cast<std::int16_t>(i * static_cast<std::size_t>(37 + number) % 2000);
    }
    return volume;
}

/// Writes all kinds of exports repeatedly over the existing files.
int exportForEver(const std::string& folder)
{
    const auto session = wholeCase(folder + "/case.angiopose");
    for (int number = 0; session; ++number) {
        const bool isWritten = io::writePng(pictureOf(number), folder + "/overlay.png") &&
                               io::writeVesselTree(*session->vessels.tree, folder + "/tree.vtp") &&
                               io::writeVesselTree(*session->vessels.tree, folder + "/tree.swc") &&
                               io::writeVolume(volumeOf(number), folder + "/scan.nii.gz") &&
                               io::writePose({}, folder + "/pose.tfm");
        if (!isWritten) {
            return 1;
        }
    }
    return 1;
}

int saveForEver(const std::string& folder)
{
    const std::string path = folder + "/case.angiopose";
    const io::CaseLock lock(path);
    auto session = wholeCase(path);
    std::string known = io::caseFileHash(path);
    for (int number = 0; session; ++number) {
        session->title = titleOf(number);
        const auto saved = io::overwriteCase(*session, path, known);
        if (!saved) {
            return 1;
        }
        known = saved.value();
    }
    return 1;
}

/// Saves once; the exit code is 0 if the case was written, 3 if it was refused with a message, 1 if the file is wrong
/// or incomplete afterward.
int saveOnce(const std::string& folder)
{
    const std::string path = folder + "/case.angiopose";
    auto session = wholeCase(path);
    if (!session) {
        return 1;
    }
    const int before = numberOf(*session);
    session->title = titleOf(before + 49);
    const auto saved = io::overwriteCase(*session, path, io::caseFileHash(path));
    if (!saved) {
        std::fprintf(stderr, "%s\n", saved.error().message.text().c_str());
    }
    const auto there = wholeCase(path);
    const bool isRight = there && numberOf(*there) == (saved ? before + 49 : before);
    return !isRight ? 1 : saved ? 0 : 3;
}

/// Increments the case's number by saving while another program may do the same; the exit code is the number of
/// successful saves, or 255 after a fault.
int countUp(const std::string& folder)
{
    const std::string path = folder + "/case.angiopose";
    int written = 0;
    for (int turn = 0; turn < 60; ++turn) {
        const std::string known = io::caseFileHash(path);
        auto session = wholeCase(path);
        if (!session) {
            return 255;
        }
        session->title = titleOf(numberOf(*session) + 1);
        const auto saved = io::overwriteCase(*session, path, known);
        if (!saved && !io::isConcurrentChange(saved.error())) {
            return 255;
        }
        written += saved ? 1 : 0;
    }
    return written;
}

}   // namespace

std::string writeSmallCase(const std::string& folder)
{
    fs::create_directories(folder + "/in");
    writeText(folder + "/in/tree.csv", "x,y,z,branch\n0,0,0,1\n10,0,0,1\n20,1,0,1\n10,0,0,2\n10,8,0,2\n");
    (void)io::writePng(pictureOf(0), folder + "/in/image.png");
    writeText(folder + "/case.angiopose", R"({"format": "angiopose-case", "version": 1, "title": "0",
        "vessel": {"centerline": {"path": "in/tree.csv"}},
        "angiogram": {"image": {"path": "in/image.png"}, "frame": 0},
        "geometry": {"camera": {"fx": -2000, "fy": 2000, "cx": 199.5, "cy": 149.5, "width": 400, "height": 300}},
        "pose": {"initial": {"cameraFromPatient": [[1,0,0,0],[0,1,0,0],[0,0,1,740],[0,0,0,1]]}}})");
    return folder + "/case.angiopose";
}

std::optional<core::Case> wholeCase(const std::string& path)
{
    core::Messages warnings;
    auto loaded = io::loadCase(path, warnings);
    const bool isWhole = loaded && loaded.value().title == titleOf(numberOf(loaded.value()));
    return isWhole ? std::optional(std::move(loaded).value()) : std::nullopt;
}

std::string titleOf(int number)
{
    return std::to_string(number) +
           (number > 0 ? " " + std::string(20'000 + 1000 * static_cast<std::size_t>(number % 50), 'x') : "");
}

int numberOf(const core::Case& session)
{
    return std::atoi(session.title.c_str());
}

int runJob(const std::string& job, const std::string& folder, int ready)
{
    (void)!::write(ready, "r", 1);
    return job == "save"     ? saveForEver(folder)
           : job == "export" ? exportForEver(folder)
           : job == "once"   ? saveOnce(folder)
                             : countUp(folder);
}

std::string findHalfWritten(const std::string& job, const std::string& folder)
{
    std::string half;
    const auto check = [&](const char* name, const auto& isWhole) {
        const std::string path = (fs::path(folder) / name).string();
        half += fs::exists(path) && !isWhole(path) ? std::string(" ") + name : "";
    };
    check("case.angiopose", [](const std::string& path) { return wholeCase(path).has_value(); });
    std::error_code absent;
    for (const auto& entry : fs::directory_iterator(folder, absent)) {   // autosaved copies of a session
        if (entry.path().filename().string().starts_with("session-") && entry.path().extension() == ".angiopose") {
            half += wholeCase(entry.path().string()) ? "" : " " + entry.path().filename().string();
        }
    }
    if (job == "export") {
        check("overlay.png", [](const std::string& path) { return static_cast<bool>(io::readAngiogram(path)); });
        check("tree.vtp", [](const std::string& path) { return static_cast<bool>(io::readVesselTree(path)); });
        check("tree.swc", [](const std::string& path) { return static_cast<bool>(io::readVesselTree(path)); });
        check("scan.nii.gz", [](const std::string& path) { return static_cast<bool>(io::readVolume(path)); });
        check("pose.tfm", [](const std::string& path) { return static_cast<bool>(io::readPose(path)); });
    }
    return half;
}

}   // namespace angiopose::test
