#include "io/vessel_tree_file.h"
#include "tests/fuzz/input_file.h"

#include <array>
#include <cstdlib>

using namespace angiopose;

// Centrelines; the first byte chooses the format. What is read is written as table, SWC and curves, and read again (VTP
// is decoded by a process of its own).
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    constexpr std::array names = {"tree.vtp", "tree.csv", "tree.swc", "tree.mrk.json"};
    const std::string_view content = fuzz::viewOf(data, size);
    const bool isOfVtk =   // decoded by a process of its own
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
