#include "io/deidentify_file.h"

#include "io/deidentify/output_folder.h"
#include "io/deidentify/remove_image_metadata.h"
#include "io/dicom/dicom_file.h"
#include "io/messages/messages.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/files_in_folder.h"

#include <algorithm>

namespace angiopose::io {
namespace {

/// Appends the messages that are not in `to` yet.
void addNew(const core::Messages& from, core::Messages& to)
{
    for (const core::Message& message : from) {
        if (std::ranges::find(to, message) == to.end()) {
            to.push_back(message);
        }
    }
}

core::Result<DeidentifiedDicom> deidentifyContent(const std::string& path, const DeidentificationOptions& options,
                                                  const Pseudonyms& pseudonyms)
{
    const auto input = openDicom(path);
    if (!input) {
        return input.error();
    }
    const auto file = parseDicom(input.value().view(), path);
    return file ? deidentifyDicom(file.value(), path, options, pseudonyms) : file.error();
}

}   // namespace

core::Result<core::Messages> deidentifyFile(const std::string& path, const std::string& output,
                                            const DeidentificationOptions& options, const Pseudonyms& pseudonyms)
{
    if (!isDicomFile(path)) {
        const auto input = openInput(path);
        const auto stripped = input ? removeImageMetadata(input.value().view(), path) : input.error();
        const core::Status written = stripped ? writeAtomically(output, stripped.value()) : stripped.error();
        return written ? core::Result<core::Messages>(core::Messages{}) : written.error();
    }
    const auto nameless = deidentifyContent(path, options, pseudonyms);
    if (!nameless) {
        return nameless.error();
    }
    const auto written = writeAtomically(output, nameless.value().content);
    return written ? core::Result<core::Messages>(nameless.value().warnings) : written.error();
}

core::Result<core::Messages> deidentifyFolder(const std::string& path, const std::string& output,
                                              const DeidentificationOptions& options, const Pseudonyms& pseudonyms,
                                              const ReadObserver& observe)
{
    const auto files = filesInFolder(path, FolderDepth::Recursive);
    if (!files) {
        return files.error();
    }
    DeidentifiedFolder folder(output);
    if (const auto opened = folder.open(); !opened) {
        return opened.error();
    }
    core::Messages warnings;
    std::size_t leftOut = 0;
    for (std::size_t n = 0; n < files.value().size(); ++n) {
        const std::string& file = files.value()[n];
        const auto image = deidentifyContent(file, options, pseudonyms);
        if (!image) {
            if (++leftOut == 1) {
                warnings.push_back(image.error().message);
            }
            continue;
        }
        if (const auto written = folder.write(image.value()); !written) {
            return written.error();
        }
        addNew(image.value().warnings, warnings);
        const double done = static_cast<double>(n + 1) / static_cast<double>(files.value().size());
        if (isStopRequested(observe, done)) {
            return readingCanceled(path);
        }
    }
    if (folder.isEmpty()) {
        return fileError(path, messages::nothingToDeidentify());
    }
    if (leftOut > 0) {
        warnings.push_back(messages::filesLeftOut(leftOut, files.value().size()));
    }
    folder.keep();
    return warnings;
}

}   // namespace angiopose::io
