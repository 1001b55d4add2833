// An angiogram in, its vessels out as points.
#include <angiopose/angiopose.h>

#include <iostream>

int main(int count, char** arguments)
try {
    if (count != 3) {
        std::cerr << "usage: trace_image ANGIOGRAM CENTRELINE.csv\n";
        return 2;
    }
    const angiopose::Angiogram run = angiopose::readAngiogram(arguments[1]);
    const angiopose::AngiogramTrace trace = angiopose::traceFrame(run, run.suggestedFrame());
    std::cout << "frame " << run.suggestedFrame() << " of " << run.frameCount() << ": "
              << trace.centerline.points.size() << " points, " << trace.suspectCurves.size()
              << " curves may be catheters\n";
    angiopose::writeCenterline2d(trace.centerline, arguments[2]);
    return 0;
} catch (const angiopose::Error& error) {
    std::cerr << error.what() << "\n";
    return 3;
}
