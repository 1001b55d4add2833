#include "io/deidentify/output_folder.h"

#include "io/messages/messages.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"

#include <array>
#include <cstdio>

namespace angiopose::io {

namespace fs = std::filesystem;

std::string instanceFileName(std::size_t number)
{
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "%05zu.dcm", number);
    return name.data();
}

DeidentifiedFolder::~DeidentifiedFolder()
{
    if (!isDone_) {
        std::error_code ignored;
        for (const fs::path& made : createdPaths_) {
            fs::remove_all(made, ignored);
        }
        if (isNew_) {
            fs::remove(path_, ignored);
        }
    }
}

core::Status DeidentifiedFolder::open()
{
    std::error_code failed;
    isNew_ = !fs::exists(path_, failed);
    if (!isNew_ && !fs::is_empty(path_, failed)) {
        return fileError(path_, messages::outputNotEmpty());
    }
    fs::create_directories(path_, failed);
    return failed ? core::Status(fileError(path_, messages::fileNotWritten(failed.message()))) : core::Done{};
}

core::Status DeidentifiedFolder::write(const DeidentifiedDicom& image)
{
    const auto [series, isNew] = counts_.try_emplace(image.seriesUid, std::pair(counts_.size() + 1, std::size_t{0}));
    auto& [number, count] = series->second;
    const fs::path folder = fs::path(path_) / ("series-" + std::to_string(number));
    if (isNew) {
        std::error_code failed;
        fs::create_directories(folder, failed);
        createdPaths_.push_back(folder);
    }
    return writeAtomically((folder / instanceFileName(++count)).string(), image.content);
}

core::Status DeidentifiedFolder::writeImage(const std::string& content, const std::string& ending)
{
    createdPaths_.push_back(fs::path(path_) / ("picture-" + std::to_string(++pictures_) + ending));
    return writeAtomically(createdPaths_.back().string(), content);
}

}   // namespace angiopose::io
