#include "io/fiducial_file.h"

#include "io/messages/messages.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"
#include "io/vessel/fiducial_table.h"

namespace angiopose::io {
namespace {

bool isMarkups(const std::string& path)
{
    return toLower(path).ends_with(".json");
}

}   // namespace

core::Result<std::vector<Fiducial>> readFiducials(const std::string& path)
{
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    const std::string_view content = input.value().view();
    return isMarkups(path) ? parseFiducialMarkups(content, path) : parseFiducialTable(content, path);
}

bool isFiducialFile(const std::string& path)
{
    return extensionOf(path) == ".fcsv" || (isMarkups(path) && readFiducials(path));
}

core::Status writeFiducials(const std::vector<Fiducial>& fiducials, const std::string& path)
{
    if (fiducials.empty()) {
        return fileError(path, messages::fiducialsNone());
    }
    if (toLower(path).ends_with(".mrk.json")) {
        return writeAtomically(path, fiducialMarkups(fiducials));
    }
    return extensionOf(path) == ".fcsv" ? writeAtomically(path, fiducialTable(fiducials))
                                        : fileError(path, messages::fiducialsExtension());
}

}   // namespace angiopose::io
