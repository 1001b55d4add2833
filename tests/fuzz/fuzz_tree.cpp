#include "io/vessel_tree_file.h"
#include "tests/fuzz/input_file.h"

#include <array>
#include <cstdlib>

using namespace angiopose;

// Fuzzes centerlines; the first byte selects the format. A tree that was read is written as a table, as SWC and as
// curves, and read back (VTP is decoded in a separate process).
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    constexpr std::array names = {"tree.vtp", "tree.csv", "tree.swc", "tree.mrk.json"};
    const std::string_view content = fuzz::viewOf(data, size);
    const bool isOfVtk =   // decoded in a separate process
        content.find("# vtk DataFile") != std::string_view::npos || content.find("<VTKFile") != std::string_view::npos;
    if (content.empty() || isOfVtk) {
        return 0;
    }
    const std::string name = names[data[0] % names.size()];
    const auto tree = io::readVesselTree(fuzz::inputFile(name, content.substr(1)));
    if (!tree) {
        return 0;
    }
    if (core::findProblem(tree.value())) {
        std::abort();
    }
    if (tree.value().pointCount() >= 2000) {
        return 0;
    }
    for (const char* written : {"tree.csv", "tree.swc", "tree.mrk.json"}) {
        const std::string again = (fuzz::folder() / (std::string("again-") + written)).string();
        if (io::writeVesselTree(tree.value(), again) && !io::readVesselTree(again)) {
            std::abort();
        }
    }
    return 0;
}
