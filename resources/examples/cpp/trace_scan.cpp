// A CT angiogram (file or DICOM folder), a label image or a surface in, a vessel tree out.
#include <angiopose/angiopose.h>

#include <iostream>

int main(int count, char** arguments)
try {
    if (count != 3) {
        std::cerr << "usage: trace_scan SCAN TREE.vtp\n";
        return 2;
    }
    angiopose::VesselReadOptions options;
    options.tracing.minBranchLengthMm = 5.0;
    const angiopose::TracedVessels vessels =
        angiopose::readVessels(arguments[1], options, [](const angiopose::Progress& progress) {
            std::cerr << "\r" << static_cast<int>(100 * progress.fraction) << " %";
            return angiopose::Verdict::Continue;   // Stop ends it: readVessels throws angiopose::Stopped
        });
    for (const angiopose::Message& warning : vessels.warnings) {
        std::cerr << "\n" << warning.text;
    }
    std::cout << "\n" << vessels.tree.points.size() << " points, lumen above " << vessels.threshold << "\n";
    angiopose::writeVesselTree(vessels.tree, arguments[2]);
    return 0;
} catch (const angiopose::Error& error) {
    std::cerr << error.what() << "\n";
    return 3;
}
