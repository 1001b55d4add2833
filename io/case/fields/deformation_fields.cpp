#include "io/case/fields/deformation_fields.h"

#include "core/registration/deformable/deform_vessels.h"
#include "io/case/fields/result_rows.h"
#include "io/support/message_json.h"
#include "io/support/pose_matrix.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using core::BranchMotion;
using core::DeformableResult;
using core::DeformationVerdict;
using core::RigidOffset;

constexpr std::size_t motionNumbers = 3;   // numbers per displacement: x, y, z
constexpr std::size_t spreadNumbers = 6;   // numbers per symmetric matrix: xx, xy, xz, yy, yz, zz

StoredField<DeformableResult> verdictField()
{
    static constexpr std::array verdicts{DeformationVerdict::Rigid, DeformationVerdict::Deformed,
                                         DeformationVerdict::Unsure};
    return {"verdict", choiceSchema({"rigid", "bent", "unsure"}),
            [](const Json& value, DeformableResult& deformed, ReadContext&) {
                deformed.verdict = *std::ranges::find(verdicts, value.get<std::string>(),
                                                      [](DeformationVerdict verdict) { return core::toText(verdict); });
            },
            [](const DeformableResult& deformed, const fs::path&) { return Json(core::toText(deformed.verdict)); }};
}

/// Returns the field of the poses of all views in the deformable registration; the first is the pose of this view.
StoredField<DeformableResult> viewPosesField()
{
    return {"viewPoses",
            about(listSchema(schemaReference("matrix")), "Of all views that determined it, this view first."),
            [](const Json& value, DeformableResult& deformed, ReadContext& reading) {
                for (const Json& rows : value) {
                    if (const auto pose = poseFromRows(rows.get<MatrixRows>())) {
                        deformed.viewPoses.push_back(pose.value());
                    } else {
                        reading.problems.push_back(pose.error().message.about("deformable"));
                    }
                }
            },
            [](const DeformableResult& deformed, const fs::path&) {
                Json list = Json::array();
                for (const core::RigidTransform& pose : deformed.viewPoses) {
                    list.push_back(rowsOf(pose));
                }
                return list;
            }};
}

StoredField<BranchMotion> motionField()
{
    return {"motionMm", about(listSchema(numberSchema()), "x, y and z of every point, patient LPS."),
            [](const Json& value, BranchMotion& motion, ReadContext&) {
                const auto numbers = value.get<std::vector<double>>();
                for (std::size_t i = 0; i + motionNumbers <= numbers.size(); i += motionNumbers) {
                    motion.displacementMm.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
                }
            },
            [](const BranchMotion& motion, const fs::path&) {
                Json numbers = Json::array();
                for (const Eigen::Vector3d& moved : motion.displacementMm) {
                    numbers.insert(numbers.end(), {moved.x(), moved.y(), moved.z()});
                }
                return numbers;
            }};
}

StoredField<BranchMotion> spreadField()
{
    return {"covarianceMm2",
            about(listSchema(numberSchema()),
                  "xx, xy, xz, yy, yz and zz of every point's position, camera axes of the view."),
            [](const Json& value, BranchMotion& motion, ReadContext&) {
                const auto numbers = value.get<std::vector<double>>();
                for (std::size_t i = 0; i + spreadNumbers <= numbers.size(); i += spreadNumbers) {
                    const double* const n = &numbers[i];
                    motion.covariance.emplace_back();
                    motion.covariance.back() << n[0], n[1], n[2], n[1], n[3], n[4], n[2], n[4], n[5];
                }
            },
            [](const BranchMotion& motion, const fs::path&) {
                Json numbers = Json::array();
                for (const Eigen::Matrix3d& m : motion.covariance) {
                    numbers.insert(numbers.end(), {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)});
                }
                return numbers;
            }};
}

StoredFields<BranchMotion> branchFieldsWithoutPoints()
{
    return {valueField("branch", Json{{"type", "integer"}}, &BranchMotion::branchId),
            measureField("seenShare", &BranchMotion::seenShare)};
}

StoredFields<BranchMotion> branchMotionFields()
{
    StoredFields<BranchMotion> rows = branchFieldsWithoutPoints();
    rows.push_back(motionField());
    rows.push_back(spreadField());
    return rows;
}

StoredFields<RigidOffset> rigidOffsetFields()
{
    return {measureField("rigidOffMm", &RigidOffset::meanMm), measureField("rigidOffMostMm", &RigidOffset::farthestMm),
            valueField("rigidOffMostAtBranch", Json{{"type", "integer"}}, &RigidOffset::farthestBranchId)};
}

/// Returns the fields of the deformation as a whole, without those of single branches.
StoredFields<DeformableResult> wholeFields()
{
    StoredFields<DeformableResult> rows{verdictField(),
                                        poseMatrixField(&DeformableResult::cameraFromPatient),
                                        measureField("logEvidenceGain", &DeformableResult::logEvidenceGain),
                                        measureField("largestMotionMm", &DeformableResult::largestMotionMm),
                                        measureField("meanMotionMm", &DeformableResult::meanMotionMm),
                                        measureField("spreadMm", &DeformableResult::spreadMm),
                                        measureField("placeStdMm", &DeformableResult::placeStdMm)};
    for (const StoredField<RigidOffset>& field : rigidOffsetFields()) {
        rows.push_back(memberField<DeformableResult>(
            [](auto& deformed) -> auto& { return deformed.rigid; }, field));
    }
    for (StoredField<DeformableResult> field :
         {measureField("explainedShare", &DeformableResult::explainedShare),
          measureField("noisePx", &DeformableResult::noisePx), stopReasonField(&DeformableResult::stopReason),
          valueField("iterations", Json{{"type", "integer"}, {"minimum", 0}}, &DeformableResult::iterations),
          measureField("timeMs", &DeformableResult::timeMs), messagesField(&DeformableResult::messages)}) {
        rows.push_back(std::move(field));
    }
    return rows;
}

StoredFields<DeformableResult> withBranches(const StoredFields<BranchMotion>& ofBranch)
{
    StoredFields<DeformableResult> rows = wholeFields();
    rows.push_back(viewPosesField());
    rows.push_back(listField("perBranch", Json::object(), &DeformableResult::branches, Json::object(), ofBranch));
    return rows;
}

Json motionSummary(const BranchMotion& branch)
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

StoredField<core::RegistrationResult> deformationField()
{
    const StoredFields<DeformableResult> fields = withBranches(branchMotionFields());
    Json schema = objectSchema(propertiesOf(fields), {"verdict", "cameraFromPatient", "viewPoses", "stopReason"});
    return {"deformable",
            about(std::move(schema), "Result of the deformable registration from the pose; absent: not requested."),
            [fields](const Json& value, core::RegistrationResult& result, ReadContext& reading) {
                core::DeformableResult deformed;
                readFields(value, deformed, fields, reading);
                result.deformed = std::make_shared<const core::DeformableResult>(std::move(deformed));
            },
            [fields](const core::RegistrationResult& result, const fs::path& folder) {
                return result.deformed ? writeFields(*result.deformed, fields, folder) : Json();
            }};
}

StoredFields<DeformableResult> deformationFieldsWithoutPoints()
{
    return withBranches(branchFieldsWithoutPoints());
}

Json deformationSummary(const core::DeformableResult& deformed)
{
    Json json = writeFields(deformed, wholeFields(), {});
    json["perBranch"] = Json::array();
    for (const core::BranchMotion& branch : deformed.branches) {
        json["perBranch"].push_back(motionSummary(branch));
    }
    json["warnings"] = sentencesOf(deformed.messages);
    return json;
}

}   // namespace angiopose::io
