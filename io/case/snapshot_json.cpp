#include "io/case/snapshot_json.h"

#include "io/support/pose_matrix.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace angiopose::io {
namespace {

using core::PoseSnapshot;
using core::SnapshotKind;
using Json = nlohmann::ordered_json;

Json metricsJson(const core::SnapshotMetrics& metrics)
{
    return {{"medianPx", metrics.medianPx},
            {"medianMm", metrics.medianMm},
            {"p95Mm", metrics.p95Mm},
            {"coverage", metrics.coverage},
            {"trustworthy", metrics.isTrustworthy}};
}

bool isFinite(const core::SnapshotMetrics& metrics)
{
    return std::isfinite(metrics.medianPx) && std::isfinite(metrics.medianMm) && std::isfinite(metrics.p95Mm) &&
           std::isfinite(metrics.coverage);
}

core::SnapshotMetrics metricsFrom(const Json& json)
{
    return {json.value("medianPx", 0.0), json.value("medianMm", 0.0), json.value("p95Mm", 0.0),
            json.value("coverage", 0.0), json.value("trustworthy", false)};
}

Json snapshotJson(const PoseSnapshot& snapshot)
{
    Json json{{"kind", snapshot.kind == SnapshotKind::Run ? "run" : "kept"}};
    for (const auto& [key, text] :
         {std::pair{"name", &snapshot.name}, std::pair{"author", &snapshot.author}, std::pair{"note", &snapshot.note},
          std::pair{"time", &snapshot.time}, std::pair{"method", &snapshot.method}}) {
        if (!text->empty()) {
            json[key] = *text;
        }
    }
    json["frame"] = snapshot.frame;
    json["cameraFromPatient"] = rowsOf(snapshot.cameraFromPatient);
    if (snapshot.metrics && isFinite(*snapshot.metrics)) {   // JSON has no NaN
        json["metrics"] = metricsJson(*snapshot.metrics);
    }
    if (snapshot.runMs > 0.0) {
        json["runMs"] = snapshot.runMs;
    }
    return json;
}

PoseSnapshot snapshotFrom(const Json& json)
{
    PoseSnapshot snapshot;
    snapshot.kind = json.value("kind", "kept") == "run" ? SnapshotKind::Run : SnapshotKind::Kept;
    snapshot.name = json.value("name", "");
    snapshot.author = json.value("author", "");
    snapshot.note = json.value("note", "");
    snapshot.time = json.value("time", "");
    snapshot.method = json.value("method", "");
    snapshot.frame = json.value("frame", 0);
    snapshot.runMs = json.value("runMs", 0.0);
    if (json.contains("metrics")) {
        snapshot.metrics = metricsFrom(json["metrics"]);
    }
    return snapshot;
}

}   // namespace

std::string snapshotsJson(const std::vector<PoseSnapshot>& snapshots)
{
    Json array = Json::array();
    for (const PoseSnapshot& snapshot : snapshots) {
        array.push_back(snapshotJson(snapshot));
    }
    return array.dump();
}

std::vector<PoseSnapshot> snapshotsFromJson(std::string_view json, core::Messages& problems)
{
    std::vector<PoseSnapshot> snapshots;
    int number = 0;
    for (const Json& each : Json::parse(json)) {
        const auto pose = poseFromRows(each["cameraFromPatient"].get<MatrixRows>());
        if (!pose) {
            problems.push_back(pose.error().message.about("snapshots: " + std::to_string(number)));
            return {};
        }
        snapshots.push_back(snapshotFrom(each));
        snapshots.back().id = ++number;
        snapshots.back().cameraFromPatient = pose.value();
    }
    return snapshots;
}

}   // namespace angiopose::io