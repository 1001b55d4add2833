#include "io/support/deformable_json.h"

#include "core/registration/registration.h"
#include "io/support/message_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson matrixRows(const core::RigidTransform& transform)
{
    const Eigen::Matrix4d matrix = transform.matrix();
    OrderedJson rows = OrderedJson::array();
    for (Eigen::Index row = 0; row < 4; ++row) {
        rows.push_back({matrix(row, 0), matrix(row, 1), matrix(row, 2), matrix(row, 3)});
    }
    return rows;
}

OrderedJson motionJson(const core::BranchMotion& branch)
{
    double sum = 0.0;
    double largest = 0.0;
    for (const Eigen::Vector3d& motion : branch.displacementMm) {
        sum += motion.norm();
        largest = std::max(largest, motion.norm());
    }
    const auto count = static_cast<double>(std::max<std::size_t>(1, branch.displacementMm.size()));
    return {{"branch", branch.branchId},
            {"meanMotionMm", sum / count},
            {"largestMotionMm", largest},
            {"seenShare", branch.seenShare}};
}

}   // namespace

std::string deformableJson(const core::DeformableResult& bent)
{
    OrderedJson json{{"verdict", std::string(core::toText(bent.verdict))},
                     {"cameraFromPatient", matrixRows(bent.cameraFromPatient)},
                     {"logEvidenceGain", bent.logEvidenceGain},
                     {"largestMotionMm", bent.largestMotionMm},
                     {"meanMotionMm", bent.meanMotionMm},
                     {"spreadMm", bent.spreadMm},
                     {"placeStdMm", bent.placeStdMm},
                     {"rigidOffMm", bent.rigid.meanMm},
                     {"rigidOffMostMm", bent.rigid.farthestMm},
                     {"rigidOffMostAtBranch", bent.rigid.farthestBranchId},
                     {"explainedShare", bent.explainedShare},
                     {"noisePx", bent.noisePx},
                     {"stopReason", std::string(core::toText(bent.stopReason))},
                     {"iterations", bent.iterations},
                     {"timeMs", bent.timeMs}};
    json["perBranch"] = OrderedJson::array();
    for (const core::BranchMotion& branch : bent.branches) {
        json["perBranch"].push_back(motionJson(branch));
    }
    json["warnings"] = sentencesOf(bent.messages);
    json["messages"] = OrderedJson::parse(messagesJson(bent.messages));
    return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

}   // namespace angiopose::io
