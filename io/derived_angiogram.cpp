#include "io/derived_angiogram.h"

#include "io/dicom/source_image.h"
#include "io/dicom/write_dicom.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"

namespace angiopose::io {

core::Status writeDerivedAngiogram(const core::Angiogram& angiogram, const std::string& path,
                                   const std::string& sourcePath)
{
    const auto source = readSourceImage(sourcePath);
    if (!source) {
        return source.error();
    }
    const auto content = encodeDicomAngiogram(angiogram, &source.value());
    return content ? writeAtomically(path, content.value()) : fileError(path, content.error());
}

}   // namespace angiopose::io
