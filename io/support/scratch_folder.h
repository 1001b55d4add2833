#pragma once

#include "core/support/result.h"

#include <filesystem>
#include <string>

namespace angiopose::io {

/// A temporary folder for the parts of one file, created next to that file, where there is enough space; removed with
/// the object.
class ScratchFolder {
public:
    explicit ScratchFolder(const std::string& besideFile);
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    core::Status make() const;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}   // namespace angiopose::io
