#include "io/deidentify_file.h"

#include "io/deidentify/strip_picture.h"
#include "io/dicom/dicom_file.h"
#include "io/messages/says.h"
#include "io/messages/says_deidentify.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/files_in_folder.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <vector>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

/// What is said of many files is said once.
void addNew(const core::Messages& from, core::Messages& to)
{
    for (const core::Message& message : from) {
        if (std::ranges::find(to, message) == to.end()) {
            to.push_back(message);
        }
    }
}

core::Result<NamelessDicom> namelessOf(const std::string& path, const Deidentification& wished,
                                       const Pseudonyms& pseudonyms)
{
    const auto input = openDicom(path);
    if (!input) {
        return input.error();
    }
    const auto file = parseDicom(input.value().view(), path);
    return file ? withoutIdentity(file.value(), path, wished, pseudonyms) : file.error();
}

/// The folder that is written to: its own until all is there.
class OutputFolder {
public:
    explicit OutputFolder(std::string path) : path_(std::move(path)) {}
    ~OutputFolder()
    {
        if (!isDone_) {
            std::error_code ignored;
            for (const fs::path& folder : made_) {
                fs::remove_all(folder, ignored);
            }
            if (isNew_) {
                fs::remove(path_, ignored);
            }
        }
    }
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    core::Status open()
    {
        std::error_code failed;
        isNew_ = !fs::exists(path_, failed);
        if (!isNew_ && !fs::is_empty(path_, failed)) {
            return fileError(path_, says::outputNotEmpty());
        }
        fs::create_directories(path_, failed);
        return failed ? core::Status(fileError(path_, says::fileNotWritten(failed.message()))) : core::Done{};
    }

    core::Status write(const NamelessDicom& image)
    {
        const auto [series, isNew] =
            counts_.try_emplace(image.seriesUid, std::pair(counts_.size() + 1, std::size_t{0}));
        auto& [number, count] = series->second;
        const fs::path folder = fs::path(path_) / ("series-" + std::to_string(number));
        if (isNew) {
            std::error_code failed;
            fs::create_directories(folder, failed);
            made_.push_back(folder);
        }
        return writeAtomically((folder / instanceFileName(++count)).string(), image.content);
    }

    bool isEmpty() const { return counts_.empty(); }
    void keep() { isDone_ = true; }

private:
    std::string path_;
    std::map<std::string, std::pair<std::size_t, std::size_t>> counts_;   ///< number and files of each series
    std::vector<fs::path> made_;
    bool isNew_ = false;
    bool isDone_ = false;
};

}   // namespace

std::string instanceFileName(std::size_t number)
{
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "%05zu.dcm", number);
    return name.data();
}

core::Result<core::Messages> deidentifyFile(const std::string& path, const std::string& output,
                                            const Deidentification& wished, const Pseudonyms& pseudonyms)
{
    if (!isDicomFile(path)) {
        const auto input = openInput(path);
        const auto stripped = input ? strippedPicture(input.value().view(), path) : input.error();
        const core::Status written = stripped ? writeAtomically(output, stripped.value()) : stripped.error();
        return written ? core::Result<core::Messages>(core::Messages{}) : written.error();
    }
    const auto nameless = namelessOf(path, wished, pseudonyms);
    if (!nameless) {
        return nameless.error();
    }
    const auto written = writeAtomically(output, nameless.value().content);
    return written ? core::Result<core::Messages>(nameless.value().warnings) : written.error();
}

core::Result<core::Messages> deidentifyFolder(const std::string& path, const std::string& output,
                                              const Deidentification& wished, const Pseudonyms& pseudonyms,
                                              const ReadObserver& observe)
{
    const auto files = filesInFolder(path, Reach::Below);
    if (!files) {
        return files.error();
    }
    OutputFolder folder(output);
    if (const auto opened = folder.open(); !opened) {
        return opened.error();
    }
    core::Messages warnings;
    std::size_t leftOut = 0;
    for (std::size_t n = 0; n < files.value().size(); ++n) {
        const std::string& file = files.value()[n];
        const auto image = namelessOf(file, wished, pseudonyms);
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
        if (isStopWished(observe, done)) {
            return stoppedReading(path);
        }
    }
    if (folder.isEmpty()) {
        return fileError(path, says::nothingToDeidentify());
    }
    if (leftOut > 0) {
        warnings.push_back(says::filesLeftOut(leftOut, files.value().size()));
    }
    folder.keep();
    return warnings;
}

}   // namespace angiopose::io
