#include "io/archive/dimse/command.h"
#include "io/archive/dimse/identifier.h"
#include "io/fiducial_file.h"
#include "io/observer_log.h"
#include "io/pose_camera_file.h"
#include "io/pose_convention_file.h"
#include "tests/mutants/mutate.h"
#include "tests/mutants/small_files.h"

#include <cstdio>

// fuzz_seeds FOLDER [DATA]: writes a folder of small valid files for every harness, made by the program's own writers,
// plus small real ones from DATA if it exists.

using namespace angiopose;

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largestSeed = 40'000;

constexpr const char* caseText = R"({"format": "angiopose-case", "version": 1,
"vessel": {"centerline": {"path": "in/tree.csv"}}, "angiogram": {"image": {"path": "in/image.png"}, "frame": 0},
"geometry": {"camera": {"fx": -2000, "fy": 2000, "cx": 7.5, "cy": 5.5, "width": 16, "height": 12}},
"pose": {"initial": {"cameraFromPatient": [[1,0,0,0],[0,1,0,0],[0,0,1,740],[0,0,0,1]]}}})";

constexpr const char* carmCaseText = R"({"format": "angiopose-case", "version": 1, "title": "x",
"vessel": {"centerline": {"path": "in/tree.csv"}, "excludedBranchIds": [2]},
"angiogram": {"image": {"path": "in/image.png"}, "frame": 0, "polarity": "dark"},
"geometry": {"sourceToDetectorMm": 1000, "sourceToIsocentreMm": 750, "primaryAngleDeg": -30, "secondaryAngleDeg": 20,
"pixelSpacingMm": [0.2, 0.2]}, "method": {"id": "angiopose", "options": {}}})";

constexpr const char* studyText = R"({"format": "angiopose-study", "version": 1, "name": "n", "seed": 2,
"casesPerSetting": 2, "trees": [{"grown": 1, "branches": 9, "extentMm": 120, "rootRadiusMm": 2.2}],
"settings": [{"name": "noisy", "frames": 1, "deformationMm": 1, "photons": 400, "maskMotionPx": 3, "catheter": 1,
"header": {"distancePercent": 2, "spacingPercent": 1, "angleDeg": 3}}]})";

/// A result that includes the case it started from.
std::string resultText()
{
    return R"({"format": "angiopose-result", "version": 2, "view": 1, "method": "angiopose", "trustworthy": true,
"pose": {"cameraFromPatient": [[1,0,0,0],[0,1,0,0],[0,0,1,740],[0,0,0,1]]}, "metrics": {"coverage": 0.9},
"inputs": {"frame": 0}, "geometry": {}, "case": )" +
           std::string(caseText) + "}";
}

/// The harness that reads a file and the byte that selects its format; "" if no harness reads it.
std::pair<std::string, std::string> placeOf(const std::string& name)
{
    const auto ends = [&name](const char* ending) { return name.ends_with(ending); };
    if (ends(".nii") || ends(".nrrd") || ends(".mha") || ends(".nii.gz")) {
        return {"volume", ""};
    }
    if (ends(".dcm") || name == "DICOMDIR") {
        return {"dicom", ""};
    }
    if (ends(".png") || ends(".jpg") || ends(".tiff") || ends(".tif")) {
        return {"picture", ""};
    }
    const std::pair<const char*, std::pair<const char*, char>> formats[] = {
        {".vtp", {"tree", 0}},   {".mrk.json", {"tree", 3}}, {".csv", {"tree", 1}},
        {".swc", {"tree", 2}},   {".stl", {"surface", 0}},   {".obj", {"surface", 1}},
        {".json", {"table", 3}}, {".tfm", {"table", 4}},     {".mat", {"table", 4}}};
    for (const auto& [ending, place] : formats) {
        if (ends(ending)) {
            return {place.first, std::string(1, place.second)};
        }
    }
    return {};
}

void keep(const fs::path& root, const std::string& harness, const std::string& name, const std::string& content)
{
    if (!harness.empty()) {
        fs::create_directories(root / harness);
        test::writeText(root / harness / name, content);
    }
}

/// Poses, points and lists as the program writes them.
void keepExchanged(const fs::path& root, const test::TemporaryFolder& scratch)
{
    const auto keepFile = [&root](char kind, const fs::path& path) {
        keep(root, "exchange", path.filename().string(), std::string(1, kind) + test::readText(path));
    };
    const core::PosedCamera sight{{-2000, 2000, 7.5, 5.5, 16, 12}, {}};
    char kind = 0;
    for (const char* name : {"sight.json", "sight.yml", "sight.xml", "sight.txt"}) {
        (void)io::writePosedCamera(sight, scratch.file(name));
        keepFile(kind++, scratch.file(name));
    }
    for (const char* name : {"points.fcsv", "points.mrk.json"}) {
        (void)io::writeFiducials({{{1, 2, 3}, "ostium", "left"}, {{4, 5, 6}, "a, \"b\"", ""}}, scratch.file(name));
        keepFile(kind++, scratch.file(name));
    }
    keep(root, "exchange", "pairs.csv", "\6x,y,z,u,v\n1,2,3,4,5\n2,3,4,5,6\n0,1,7,8,9\n");
    (void)io::appendTrial({"2026-01-02T03:04:05Z", "A", "case, 1", "ab", 3, 7, 5.0, 6.0, 60.0, 4},
                          scratch.file("log.csv"));
    keepFile('\7', scratch.file("log.csv"));
    keep(root, "exchange", "cases.csv", "\10case,reference,patient,pose.other\na.angiopose,a.json,1,b.tfm\n");
    keep(root, "exchange", "study.json", std::string(1, '\11') + studyText);
    (void)io::writeDiffDrr(core::diffDrrView(sight, 1000.0, {1, 2, 3}), scratch.file("view.json"));
    keepFile('\12', scratch.file("view.json"));
    keep(root, "exchange", "result.json", std::string(1, '\13') + resultText());
}

/// What a peer answers when all is well.
void keepAnswers(const fs::path& root)
{
    io::DimseCommand request(io::DimseMessageType::FindRequest, 1, "1.2.840.10008.5.1.4.1.2.2.1");
    request.setHasData();
    keep(root, "peer", "request", std::string(1, '\0') + request.encoded());
    keep(root, "peer", "response", std::string(1, '\0') + request.response(io::dimse::pending).encoded());
    keep(root, "peer", "identifier",
         std::string(1, '\1') +
             io::encodeIdentifier({{0x00080052, "STUDY"}, {0x00100010, "A^B"}, {0x0020000d, "1.2.3"}}));
    keep(root, "peer", "matches.json",
         std::string(1, '\2') + R"([{"0020000D": {"vr": "UI", "Value": ["1.2.3"]}, "00100010": {"vr": "PN",
"Value": [{"Alphabetic": "A^B"}]}, "00201208": {"vr": "IS", "Value": [12]}}])");
    keep(root, "peer", "stored.json",
         std::string(1, '\2') + R"({"00081198": {"vr": "SQ", "Value": [{"00081197": {"vr": "US", "Value": [272]}}]}})");
    keep(root, "peer", "parts",
         "\3multipart/related; type=\"application/dicom\"; boundary=abc\n--abc\r\nContent-Type: "
         "application/dicom\r\n\r\none\r\n--abc\r\n\r\ntwo\r\n--abc--\r\n");
}

}   // namespace

int main(int count, char** values)
{
    if (count < 2) {
        std::puts("Usage: fuzz_seeds FOLDER [DATA]");
        return 2;
    }
    const fs::path root(values[1]);
    const std::string data = count > 2 ? values[2] : "";
    const test::TemporaryFolder scratch;
    for (const test::SmallFile& file : test::smallFiles(data, scratch)) {
        const auto [harness, kind] = placeOf(file.name);
        const std::string content = kind + (file.isGzip ? test::gzipped(file.content) : file.content);
        keep(root, harness, file.name, content);
        keep(root, harness == "dicom" ? "object" : "", file.name, content);
    }
    keep(root, "case", "camera.angiopose", caseText);
    keep(root, "case", "carm.angiopose", carmCaseText);
    keep(root, "table", "curves.csv", std::string(1, '\0') + "x,y,curve\n1,2,1\n3,4,1\n5,6,2\n7,9,2\n");
    keep(root, "table", "cases.csv", std::string(1, '\1') + "case,method\na.angiopose,angiopose\nb.angiopose,\n");
    keep(root, "table", "pose.json",
         std::string(1, '\3') + R"({"cameraFromPatient": [[1,0,0,0],[0,1,0,0],[0,0,1,740],[0,0,0,1]]})");
    keepAnswers(root);
    keepExchanged(root, scratch);
    if (!data.empty() && fs::exists(data)) {
        int number = 0;
        for (const auto& entry : fs::recursive_directory_iterator(data)) {
            if (entry.is_regular_file() && entry.file_size() <= largestSeed) {
                const std::string name = entry.path().filename().string();
                const auto [harness, kind] = placeOf(name);
                const std::string seed = std::to_string(++number) + "-" + name;
                const std::string content = kind + test::readText(entry.path());
                keep(root, harness, seed, content);
                keep(root, harness == "dicom" ? "object" : "", seed, content);
            }
        }
    }
    return 0;
}
