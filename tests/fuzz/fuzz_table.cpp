#include "core/vessel/centerline2d.h"
#include "io/case/batch_manifest.h"
#include "io/centerline2d_file.h"
#include "io/evaluation/run_files.h"
#include "io/pose_file.h"
#include "tests/fuzz/input_file.h"

#include <array>
#include <cstdlib>

using namespace angiopose;

// Fuzzes curves, case lists, registrations of studies and poses; the first byte selects the reader.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0) {
        return 0;
    }
    const std::string_view content = fuzz::viewOf(data, size).substr(1);
    switch (data[0] % 5) {
        case 0:
            if (const auto curves = io::readCenterline2d(fuzz::inputFile("curves.csv", content));
                curves && core::findProblem(curves.value())) {
                std::abort();
            }
            break;
        case 1:
            (void)io::readManifest(fuzz::inputFile("cases.csv", content));
            break;
        case 2:
            fuzz::inputFile("runs.csv", content);
            (void)io::readRuns(fuzz::folder().string());
            break;
        case 3:
            (void)io::readPose(fuzz::inputFile("pose.json", content));
            break;
        default:
            (void)io::readPose(fuzz::inputFile("pose.tfm", content));
            break;
    }
    return 0;
}
