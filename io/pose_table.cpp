#include "io/pose_table.h"

#include "io/support/atomic_file.h"
#include "io/support/numbers.h"

namespace angiopose::io {

core::Status writePoseTable(std::span<const core::TrackedRunFrame> frames, const std::string& path)
{
    std::string table =
        "frame,trustworthy,searched,score,r11,r12,r13,tx,r21,r22,r23,ty,r31,r32,r33,tz,bentMeanMm,bentLargestMm\n";
    for (const core::TrackedRunFrame& frame : frames) {
        const core::TrackedFrame& tracked = frame.tracked;
        table += std::to_string(frame.frame) + (tracked.isTrustworthy ? ",1" : ",0") +
                 (tracked.isFromSearch ? ",1," : ",0,") + toText(tracked.score);
        const Eigen::Matrix4d matrix = tracked.cameraFromPatient.matrix();
        for (Eigen::Index row = 0; row < 3; ++row) {
            for (Eigen::Index column = 0; column < 4; ++column) {
                table += "," + toText(matrix(row, column));
            }
        }
        table += frame.deformed && !frame.deformationSourceFrame
                     ? "," + toText(frame.deformed->meanMotionMm) + "," + toText(frame.deformed->largestMotionMm)
                     : ",,";
        table += "\n";
    }
    return writeAtomically(path, table);
}

}   // namespace angiopose::io
