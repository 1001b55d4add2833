#include "io/snapshot_table.h"

#include "core/geometry/pose_difference.h"
#include "io/support/atomic_file.h"
#include "io/support/csv_table.h"
#include "io/support/numbers.h"
#include "io/support/pose_matrix.h"

#include <cmath>

namespace angiopose::io {
namespace {

constexpr std::string_view snapshotHeader =
    "pose,kind,method,author,time,frame,median_px,median_mm,p95_mm,coverage,trustworthy,run_ms,in_plane_difference_mm,"
    "depth_difference_mm,rotation_difference_deg,r00,r01,r02,t0,r10,r11,r12,t1,r20,r21,r22,t2,note\n";

std::string snapshotCell(double value)
{
    return std::isfinite(value) ? toText(value) : std::string();
}

std::string metricCells(const std::optional<core::SnapshotMetrics>& metrics)
{
    if (!metrics) {
        return ",,,,";
    }
    return snapshotCell(metrics->medianPx) + "," + snapshotCell(metrics->medianMm) + "," +
           snapshotCell(metrics->p95Mm) + "," + snapshotCell(metrics->coverage) + "," +
           (metrics->isTrustworthy ? "yes" : "no");
}

}   // namespace

std::string poseCells(const core::RigidTransform& cameraFromPatient)
{
    std::string text;
    const MatrixRows rows = rowsOf(cameraFromPatient);
    for (std::size_t row = 0; row < 3; ++row) {
        for (const double value : rows[row]) {
            text += (text.empty() ? "" : ",") + toText(value);
        }
    }
    return text;
}

std::string snapshotTable(std::span<const core::PoseSnapshot> snapshots, const core::PoseSnapshot& reference,
                          const Eigen::Vector3d& pivotInPatient)
{
    std::string text(snapshotHeader);
    for (const core::PoseSnapshot& each : snapshots) {
        const core::PoseDifference difference =
            core::differenceBetween(reference.cameraFromPatient, each.cameraFromPatient, pivotInPatient);
        text += csvCell(each.name) + (each.kind == core::SnapshotKind::Run ? ",run," : ",kept,") +
                csvCell(each.method) + "," + csvCell(each.author) + "," + csvCell(each.time) + "," +
                std::to_string(each.frame) + "," + metricCells(each.metrics) + "," +
                (each.runMs > 0.0 ? snapshotCell(each.runMs) : "") + "," + snapshotCell(difference.inPlaneMm) + "," +
                snapshotCell(difference.depthMm) + "," + snapshotCell(difference.rotationDeg) + "," +
                poseCells(each.cameraFromPatient) + "," + csvCell(each.note) + "\n";
    }
    return text;
}

core::Status writeSnapshotTable(std::span<const core::PoseSnapshot> snapshots, const core::PoseSnapshot& reference,
                                const Eigen::Vector3d& pivotInPatient, const std::string& path)
{
    return writeAtomically(path, snapshotTable(snapshots, reference, pivotInPatient));
}

}   // namespace angiopose::io
