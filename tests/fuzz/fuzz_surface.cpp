#include "io/surface_file.h"
#include "tests/fuzz/input_file.h"

#include <array>

using namespace angiopose;

// Fuzzes STL and OBJ; the first byte selects the format. PLY and legacy VTK are decoded in a separate process.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    constexpr std::array names = {"box.stl", "box.obj", "box.vtp"};
    const std::string_view content = fuzz::viewOf(data, size);
    if (!content.empty() && !content.substr(1).starts_with("ply") && !content.substr(1).starts_with("# vtk")) {
        (void)io::readSurface(fuzz::inputFile(names[data[0] % names.size()], content.substr(1)));
    }
    return 0;
}
