#pragma once

#include "core/registration/registration.h"

#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

/// Whether the user saved the snapshot or a registration created it.
enum class SnapshotKind { Kept, Run };

/// Agreement of a snapshot's pose with its frame, computed when it was taken.
struct SnapshotMetrics {
    double medianPx = 0.0;
    double medianMm = 0.0;
    double p95Mm = 0.0;
    double coverage = 0.0;   ///< 0…1
    bool isTrustworthy = false;

    bool operator==(const SnapshotMetrics&) const = default;
};

/// Saved pose with its origin: method, time, frame and quality of the fit.
struct PoseSnapshot {
    int id = 0;   ///< unique in the case
    SnapshotKind kind = SnapshotKind::Kept;
    std::string name;
    std::string author;
    std::string note;
    std::string time;   ///< ISO 8601, UTC
    std::string method;   ///< id of the method that found it; empty: set manually
    int frame = 0;   ///< frame of the angiogram, counts from 0
    RigidTransform cameraFromPatient;
    std::optional<SnapshotMetrics> metrics;   ///< nullopt: not computed
    double runMs = 0.0;   ///< 0: not found by a registration
    std::string extraKeys{};   ///< JSON object with keys of the case file that this version does not know
};

/// Metrics of a judged pose to store in a snapshot.
SnapshotMetrics metricsOf(const RegistrationResult& result);

/// Appends `added` to `snapshots` with a new id. Keeps only the newest `keptRuns` snapshots of registrations, and all
/// snapshots saved by the user.
std::vector<PoseSnapshot> withSnapshot(std::vector<PoseSnapshot> snapshots, PoseSnapshot added, int keptRuns = 20);

/// Snapshot with this id, or null.
const PoseSnapshot* findSnapshot(const std::vector<PoseSnapshot>& snapshots, int id);

}   // namespace angiopose::core