#pragma once

#include "core/registration/registration.h"

#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

/// Origin of a snapshot: saved by the user, or created by a registration.
enum class SnapshotKind { Saved, Run };

/// Quality of fit of a snapshot's pose in its frame, computed when the snapshot was taken.
struct SnapshotMetrics {
    double medianPx = 0.0;
    double medianMm = 0.0;
    double p95Mm = 0.0;
    double coverage = 0.0;   ///< 0…1
    bool isTrustworthy = false;

    bool operator==(const SnapshotMetrics&) const = default;
};

/// Saved pose with its method, time, frame and quality of fit.
struct PoseSnapshot {
    int id = 0;   ///< unique within the case
    SnapshotKind kind = SnapshotKind::Saved;
    std::string name;
    std::string author;
    std::string note;
    std::string time;   ///< ISO 8601, UTC
    std::string method;   ///< id of the method that found the pose; empty if set manually
    int frame = 0;   ///< frame of the angiogram, starting at 0
    RigidTransform cameraFromPatient;
    std::optional<SnapshotMetrics> metrics;   ///< nullopt if not computed
    double runMs = 0.0;   ///< duration of the registration; 0 if the pose does not come from a registration
    std::string extraKeys{};   ///< JSON object with the case-file keys that this version does not recognize
};

/// Returns the metrics of an assessed pose that are stored in a snapshot.
SnapshotMetrics metricsOf(const RegistrationResult& result);

/// Returns the list with `added` appended under a new id. Keeps all snapshots saved by the user, but only the newest
/// `maxRuns` of those created by registrations.
std::vector<PoseSnapshot> withSnapshot(std::vector<PoseSnapshot> snapshots, PoseSnapshot added, int maxRuns = 20);

/// Returns the snapshot with this id, or null.
const PoseSnapshot* findSnapshot(const std::vector<PoseSnapshot>& snapshots, int id);

}   // namespace angiopose::core
