#pragma once

#include "core/registration/registration.h"

#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

/// Whether a user kept the pose, or a run left it behind.
enum class SnapshotKind { Kept, Run };

/// How well a snapshot's pose agreed with its frame, as judged when it was taken.
struct SnapshotMetrics {
    double medianPx = 0.0;
    double medianMm = 0.0;
    double p95Mm = 0.0;
    double coverage = 0.0;   ///< 0…1
    bool isTrustworthy = false;

    bool operator==(const SnapshotMetrics&) const = default;
};

/// A pose with its story: who found it, when, how, and how well it fitted.
struct PoseSnapshot {
    int id = 0;   ///< unique in the case
    SnapshotKind kind = SnapshotKind::Kept;
    std::string name;
    std::string author;
    std::string note;
    std::string time;   ///< ISO 8601, UTC
    std::string method;   ///< id of the method that found it; empty: by hand
    int frame = 0;   ///< of the angiogram, counts from 0
    RigidTransform cameraFromPatient;
    std::optional<SnapshotMetrics> metrics;   ///< nothing: not judged
    double runMs = 0.0;   ///< 0: not found by a run
    std::string extraKeys{};   ///< JSON object with what a case file says of it that this version does not know
};

/// What a snapshot remembers of a judged pose.
SnapshotMetrics metricsOf(const RegistrationResult& result);

/// `snapshots` with `added` at the end under a fresh id. Of the runs only the newest `keptRuns` stay; what a user kept
/// always stays.
std::vector<PoseSnapshot> withSnapshot(std::vector<PoseSnapshot> snapshots, PoseSnapshot added, int keptRuns = 20);

/// The snapshot with this id, or null.
const PoseSnapshot* findSnapshot(const std::vector<PoseSnapshot>& snapshots, int id);

}   // namespace angiopose::core