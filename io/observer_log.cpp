#include "io/observer_log.h"

#include "core/geometry/pose_difference.h"
#include "io/messages/messages.h"
#include "io/snapshot_table.h"
#include "io/support/atomic_file.h"
#include "io/support/csv_table.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"

#include <filesystem>

namespace angiopose::io {
namespace {

std::string poseColumns(const std::string& prefix)
{
    std::string text;
    for (const char* name : {"r00", "r01", "r02", "t0", "r10", "r11", "r12", "t1", "r20", "r21", "r22", "t2"}) {
        text += "," + prefix + "_" + name;
    }
    return text;
}

const std::string pivotColumns = ",pivot_x,pivot_y,pivot_z";

/// Returns the header of logs started by versions that did not record the centroid.
std::string olderHeader()
{
    return "started_at,observer,case,image_sha256,frame,seed,range_mm,range_deg,duration_s,edits,outcome,"
           "in_plane_from_centre_mm,depth_from_centre_mm,rotation_from_centre_deg" +
           poseColumns("start") + poseColumns("final") + poseColumns("centre");
}

std::string pivotCells(const Eigen::Vector3d& pivot)
{
    return "," + toText(pivot.x()) + "," + toText(pivot.y()) + "," + toText(pivot.z());
}

std::string rowOf(const ObserverTrial& trial)
{
    const core::PoseDifference difference =
        core::differenceBetween(trial.centerPose, trial.finalPose, trial.pivotInPatient);
    return csvCell(trial.startedAt) + "," + csvCell(trial.observer) + "," + csvCell(trial.caseTitle) + "," +
           csvCell(trial.imageSha256) + "," + std::to_string(trial.frame) + "," + std::to_string(trial.seed) + "," +
           toText(trial.rangeMm) + "," + toText(trial.rangeDeg) + "," + toText(trial.durationS) + "," +
           std::to_string(trial.editCount) + (trial.isAbandoned ? ",abandoned," : ",done,") +
           toText(difference.inPlaneMm) + "," + toText(difference.depthMm) + "," + toText(difference.rotationDeg) +
           "," + poseCells(trial.initialPose) + "," + poseCells(trial.finalPose) + "," + poseCells(trial.centerPose);
}

}   // namespace

core::Status appendTrial(const ObserverTrial& trial, const std::string& path)
{
    std::string content = olderHeader() + pivotColumns + "\n";
    bool hasPivots = true;
    if (std::error_code absent; std::filesystem::exists(path, absent)) {
        const auto before = openInput(path);
        if (!before) {
            return before.error();
        }
        hasPivots = before.value().view().starts_with(content);
        if (!hasPivots && !before.value().view().starts_with(olderHeader() + "\n")) {
            return fileError(path, messages::noObserverLog());
        }
        content = before.value().view();
        content += content.ends_with('\n') ? "" : "\n";
    }
    return writeAtomically(path, content + rowOf(trial) + (hasPivots ? pivotCells(trial.pivotInPatient) : "") + "\n");
}

}   // namespace angiopose::io
