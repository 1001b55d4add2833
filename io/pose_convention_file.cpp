#include "io/pose_convention_file.h"

#include "io/messages/messages.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"

namespace angiopose::io {

core::Result<DiffDrrParts> readDiffDrr(const std::string& path)
{
    const std::string extension = extensionOf(path);
    if (extension == ".pt" || extension == ".pth") {
        return fileError(path, messages::exchangePickle());
    }
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    return extension == ".csv" ? parseDiffDrrTable(input.value().view(), path)
                               : parseDiffDrrJson(input.value().view(), path);
}

core::Result<core::PosedCamera> posedCameraFrom(const DiffDrrParts& parts)
{
    if (!parts.detector) {
        return core::Error(messages::diffDrrKeys("sdd"));
    }
    if (!parts.pose) {
        return core::Error(messages::diffDrrKeys("pose"));
    }
    return core::posedCameraFromDiffDrr(
        {*parts.detector, *parts.pose, parts.volumeCenterInPatient.value_or(Eigen::Vector3d::Zero())});
}

core::Status writeDiffDrr(const core::DiffDrrView& view, const std::string& path)
{
    return extensionOf(path) == ".json" ? writeAtomically(path, diffDrrText(view))
                                        : fileError(path, messages::exchangeExtension());
}

}   // namespace angiopose::io
