#include "core/registration/pose_snapshot.h"

#include <algorithm>
#include <utility>

namespace angiopose::core {

SnapshotMetrics metricsOf(const RegistrationResult& result)
{
    const DistanceMetrics& metrics = result.metrics;
    return {metrics.medianPx, metrics.medianMm, metrics.p95Mm, metrics.coverage, result.trustworthy};
}

std::vector<PoseSnapshot> withSnapshot(std::vector<PoseSnapshot> snapshots, PoseSnapshot added, int maxRuns)
{
    int highest = 0;
    for (const PoseSnapshot& snapshot : snapshots) {
        highest = std::max(highest, snapshot.id);
    }
    added.id = highest + 1;
    snapshots.push_back(std::move(added));
    auto surplus = std::ranges::count(snapshots, SnapshotKind::Run, &PoseSnapshot::kind) - maxRuns;
    std::erase_if(snapshots, [&surplus](const PoseSnapshot& snapshot) {   // erases the oldest first
        return snapshot.kind == SnapshotKind::Run && surplus-- > 0;
    });
    return snapshots;
}

const PoseSnapshot* findSnapshot(const std::vector<PoseSnapshot>& snapshots, int id)
{
    const auto found = std::ranges::find(snapshots, id, &PoseSnapshot::id);
    return found == snapshots.end() ? nullptr : &*found;
}

}   // namespace angiopose::core
