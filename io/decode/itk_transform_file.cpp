#include "io/decode/itk_transform_file.h"

#include "io/decode/ask_decoder.h"
#include "io/messages/messages.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/support/pose_matrix.h"

namespace angiopose::io {
namespace {

constexpr const char* program = "angiopose-decode-itk";

}   // namespace

core::Result<core::RigidTransform> poseFromItkHdf5(const std::string& path, const ReadObserver& observe)
{
    const auto reply = runDecoder(program, {"read", path}, path, observe);
    if (!reply) {
        return reply.error();
    }
    const auto& [kind, content] = reply.value();
    std::array<std::array<double, 4>, 3> rows{};
    ReplyReader reader(content);
    reader.take(rows);
    if (kind != ReplyKind::Result || !reader.isDone()) {
        const bool hasType = kind == ReplyKind::Refusal && !content.empty();
        return fileError(
            path, hasType ? messages::poseNotRigidTransform(content.substr(0, 60)) : messages::poseNoTransform());
    }
    MatrixRows matrix;
    for (const auto& row : rows) {
        matrix.emplace_back(row.begin(), row.end());
    }
    matrix.push_back({0.0, 0.0, 0.0, 1.0});
    const auto pose = poseFromRows(matrix);
    return pose ? pose : fileError(path, pose.error());
}

core::Status writeItkHdf5(const core::RigidTransform& cameraFromPatient, const std::string& path)
{
    std::vector<std::string> arguments{"write"};
    const MatrixRows matrix = rowsOf(cameraFromPatient);
    for (std::size_t row = 0; row < 3; ++row) {
        for (const double value : matrix[row]) {
            arguments.push_back(toText(value));
        }
    }
    const auto reply = runDecoder(program, arguments, path);
    if (!reply) {
        return reply.error();
    }
    return reply.value().kind == ReplyKind::Result ? writeAtomically(path, reply.value().content)
                                                   : fileError(path, messages::decoderDied());
}

}   // namespace angiopose::io
