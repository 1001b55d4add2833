#include "io/deidentify_files.h"

#include "io/deidentify/output_folder.h"
#include "io/deidentify/remove_image_metadata.h"
#include "io/deidentify/remove_tiff_metadata.h"
#include "io/dicom/dicom_file.h"
#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/files_in_folder.h"

#include <algorithm>
#include <filesystem>

namespace angiopose::io {
namespace {

/// Lists the given files and the files in the given folders without duplicates.
core::Result<std::vector<std::string>> filesOfAll(const std::vector<std::string>& paths)
{
    std::vector<std::string> files;
    for (const std::string& path : paths) {
        std::error_code failed;
        if (!std::filesystem::is_directory(path, failed)) {
            files.push_back(path);
            continue;
        }
        auto inside = filesInFolder(path, FolderDepth::Recursive);
        if (!inside) {
            return inside.error();
        }
        files.insert(files.end(), inside.value().begin(), inside.value().end());
    }
    std::ranges::sort(files);
    files.erase(std::unique(files.begin(), files.end()), files.end());
    return files;
}

std::string pictureEnding(std::string_view picture)
{
    return looksLikeTiff(picture) ? ".tif" : picture.starts_with("\x89PNG") ? ".png" : ".jpg";
}

class FileCleaner {
public:
    FileCleaner(const std::string& output, const DeidentificationOptions& options, const Pseudonyms& pseudonyms)
        : folder_(output), requested_(options), pseudonyms_(pseudonyms)
    {
    }

    core::Status open() { return folder_.open(); }

    /// De-identifies one file; fails only if no more files can be written.
    core::Status take(const std::string& path) { return isDicomFile(path) ? takeDicom(path) : takePicture(path); }

    bool isEmpty() const { return folder_.isEmpty(); }
    DeidentifiedFiles keep()
    {
        folder_.keep();
        return std::move(done_);
    }
    const core::Messages& skipped() const { return done_.skipped; }

private:
    core::Status takeDicom(const std::string& path)
    {
        const auto input = openDicom(path);
        const auto file = input ? parseDicom(input.value().view(), path) : core::Result<DicomFile>(input.error());
        const auto image = file ? deidentifyDicom(file.value(), path, requested_, pseudonyms_)
                                : core::Result<DeidentifiedDicom>(file.error());
        if (!image) {
            return refuse(image.error());
        }
        for (const core::Message& warning : image.value().warnings) {
            if (std::ranges::find(done_.warnings, warning) == done_.warnings.end()) {
                done_.warnings.push_back(warning);
            }
        }
        return count(folder_.write(image.value()));
    }

    core::Status takePicture(const std::string& path)
    {
        const auto input = openInput(path);
        const auto stripped =
            input ? removeImageMetadata(input.value().view(), path) : core::Result<std::string>(input.error());
        return stripped ? count(folder_.writeImage(stripped.value(), pictureEnding(stripped.value())))
                        : refuse(stripped.error());
    }

    core::Status refuse(const core::Error& error)
    {
        done_.skipped.push_back(error.message);
        return core::Done{};
    }

    core::Status count(core::Status written)
    {
        done_.written += written ? 1 : 0;
        return written;
    }

    DeidentifiedFolder folder_;
    const DeidentificationOptions& requested_;
    const Pseudonyms& pseudonyms_;
    DeidentifiedFiles done_;
};

}   // namespace

core::Result<DeidentifiedFiles> deidentifyFiles(const std::vector<std::string>& paths, const std::string& output,
                                                const DeidentificationOptions& options, const Pseudonyms& pseudonyms,
                                                const ReadObserver& observe)
{
    const auto files = filesOfAll(paths);
    if (!files) {
        return files.error();
    }
    FileCleaner cleaner(output, options, pseudonyms);
    if (const auto opened = cleaner.open(); !opened) {
        return opened.error();
    }
    for (std::size_t n = 0; n < files.value().size(); ++n) {
        if (isStopRequested(observe, static_cast<double>(n) / static_cast<double>(files.value().size()))) {
            return readingCanceled(output);
        }
        if (const auto taken = cleaner.take(files.value()[n]); !taken) {
            return taken.error();
        }
    }
    if (cleaner.isEmpty()) {
        const auto& skipped = cleaner.skipped();
        return skipped.size() == 1 ? core::Error(skipped.front())
                                   : fileError(paths.empty() ? output : paths.front(), messages::nothingToDeidentify());
    }
    return cleaner.keep();
}

}   // namespace angiopose::io
