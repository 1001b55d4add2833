#include "io/dicom/open_dicom.h"

#include "io/dicom/dicom_file.h"
#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/inflate.h"

namespace angiopose::io {
namespace {

constexpr std::size_t maxUnpackedFileBytes = std::size_t{256} << 20;

}   // namespace

core::Result<InputBytes> openDicom(const std::string& path)
{
    auto input = openInput(path);
    if (!input) {
        return input;
    }
    if (looksLikeDicom(input.value().view())) {
        return input;
    }
    if (input.value().view().starts_with("\x1f\x8b")) {
        auto unpacked = inflated(input.value().view(), Packing::Gzip, maxUnpackedFileBytes);
        if (unpacked && looksLikeDicom(*unpacked)) {
            return InputBytes(std::move(*unpacked));
        }
    }
    return fileError(path, says::dicomNotOne());
}

bool isDicomFile(const std::string& path)
{
    return static_cast<bool>(openDicom(path));
}

}   // namespace angiopose::io