#pragma once

#include "core/support/result.h"
#include "io/deidentify/deidentify_dicom.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace angiopose::io {

/// Returns a neutral file name for an image in a series, for example "00001.dcm", because original file names can
/// identify patients.
std::string instanceFileName(std::size_t number);

/// New or empty output folder of a de-identification, with files named `series-1/00001.dcm` and `picture-1.png`. The
/// destructor deletes the contents of the folder unless `keep` was called.
class DeidentifiedFolder {
public:
    explicit DeidentifiedFolder(std::string path) : path_(std::move(path)) {}
    ~DeidentifiedFolder();
    DeidentifiedFolder(const DeidentifiedFolder&) = delete;
    DeidentifiedFolder& operator=(const DeidentifiedFolder&) = delete;

    core::Status open();
    core::Status write(const DeidentifiedDicom& image);
    core::Status writeImage(const std::string& content, const std::string& ending);

    bool isEmpty() const { return counts_.empty() && pictures_ == 0; }
    void keep() { isDone_ = true; }

private:
    std::string path_;
    std::map<std::string, std::pair<std::size_t, std::size_t>> counts_;   ///< number and file count of each series
    std::size_t pictures_ = 0;
    std::vector<std::filesystem::path> createdPaths_;
    bool isNew_ = false;
    bool isDone_ = false;
};

}   // namespace angiopose::io
