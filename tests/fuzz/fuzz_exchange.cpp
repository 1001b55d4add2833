#include "io/evaluation/cohort_manifest.h"
#include "io/evaluation/observer_readings.h"
#include "io/fiducial_file.h"
#include "io/opening/open_result.h"
#include "io/pose_camera_file.h"
#include "io/pose_convention_file.h"
#include "io/simulation/study_file.h"
#include "tests/fuzz/small_inputs.h"

#include <array>
#include <cstdlib>

using namespace angiopose;

namespace {

void readPoints(const std::string& name, std::string_view content)
{
    const std::string path = fuzz::inputFile(name, content);
    (void)io::readLandmarks(path);
    const auto points = io::readFiducials(path);
    if (!points) {
        return;
    }
    for (const char* written : {"again.fcsv", "again.mrk.json"}) {
        const std::string again = (fuzz::folder() / written).string();
        if (!io::writeFiducials(points.value(), again)) {
            std::abort();
        }
        const auto read = io::readFiducials(again);
        if (!read || read.value().size() != points.value().size()) {
            std::abort();
        }
    }
}

void readSight(const std::string& name, std::string_view content)
{
    const auto pose = io::readPoseWithCamera(fuzz::inputFile(name, content));
    if (!pose || !pose.value().camera) {
        return;
    }
    for (const char* written : {"again.json", "again.yml", "again.xml", "again.txt"}) {
        const std::string again = (fuzz::folder() / written).string();
        if (io::writePosedCamera({*pose.value().camera, pose.value().cameraFromPatient}, again) &&
            !io::readPoseWithCamera(again)) {
            std::abort();
        }
    }
}

}   // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
    fuzz::writeSmallInputs();
    return 0;
}

// Fuzzes the formats exchanged with other programs and the lists and results of studies; the first byte selects the
// reader.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0) {
        return 0;
    }
    constexpr std::array sights = {"sight.json", "sight.yml", "sight.xml", "sight.txt"};
    const std::string_view content = fuzz::viewOf(data, size).substr(1);
    const int choice = data[0] % 12;
    core::Messages warnings;
    switch (choice) {
        case 0:
        case 1:
        case 2:
        case 3:
            readSight(sights.at(static_cast<std::size_t>(choice)), content);
            break;
        case 4:
            readPoints("points.fcsv", content);
            break;
        case 5:
            readPoints("points.mrk.json", content);
            break;
        case 6:
            (void)io::readPointPairs(fuzz::inputFile("pairs.csv", content));
            break;
        case 7:
            (void)io::readObserverReadings(fuzz::inputFile("log.csv", content));
            break;
        case 8:
            (void)io::readCohortManifest(fuzz::inputFile("cases.csv", content));
            break;
        case 9:
            (void)io::readStudy(fuzz::inputFile("study.json", content));
            break;
        case 10:
            if (const auto parts = io::readDiffDrr(fuzz::inputFile("view.json", content))) {
                (void)io::posedCameraFrom(parts.value());
            }
            break;
        default:
            (void)io::openResultCase({fuzz::inputFile("result.json", content), {}}, warnings);
            break;
    }
    return 0;
}
