#include "core/imaging/image2d.h"
#include "io/case/case_file.h"
#include "io/image_file.h"
#include "tests/fuzz/input_file.h"

using namespace angiopose;

// Case files beside a small tree and image, which they may name: in/tree.csv, in/image.png.
extern "C" int LLVMFuzzerInitialize(int*, char***)
{
    std::filesystem::create_directories(fuzz::folder() / "in");
    fuzz::inputFile("in/tree.csv", "x,y,z,branch\n0,0,0,1\n10,0,0,1\n20,1,0,1\n10,0,0,2\n10,8,0,2\n");
    const core::ColorImage picture{16, 12, std::vector<std::uint8_t>(16 * 12 * 3, 90)};
    (void)io::writePng(picture, (fuzz::folder() / "in/image.png").string());
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string path = fuzz::inputFile("case.angiopose", fuzz::viewOf(data, size));
    (void)io::validateCase(path);
    core::Messages warnings;
    if (const auto loaded = io::loadCase(path, warnings); loaded && !io::findUnsavable(loaded.value())) {
        (void)io::saveCase(loaded.value(), (fuzz::folder() / "again.angiopose").string());
    }
    return 0;
}
