#include "io/case/case_file.h"
#include "tests/fuzz/small_inputs.h"

using namespace angiopose;

// Fuzzes case files, next to a small tree and image that they may reference.
extern "C" int LLVMFuzzerInitialize(int*, char***)
{
    fuzz::writeSmallInputs();
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string path = fuzz::inputFile("case.angiopose", fuzz::viewOf(data, size));
    (void)io::validateCase(path);
    core::Messages warnings;
    if (const auto loaded = io::loadCase(path, warnings); loaded && !io::findSaveObstacle(loaded.value())) {
        (void)io::saveCase(loaded.value(), (fuzz::folder() / "again.angiopose").string());
    }
    return 0;
}
