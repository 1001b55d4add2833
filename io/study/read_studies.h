#pragma once

#include "core/support/result.h"
#include "core/support/verdict.h"
#include "io/study/study_tree.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace angiopose::io {

/// Which files are read: those that a DICOMDIR lists, if there is one, or all files of the folder.
enum class StudyReach { Listed, AllFiles };

struct StudyProgress {
    std::size_t read = 0;
    std::size_t found = 0;   ///< grows while folders are searched, before any file is read
    std::shared_ptr<const StudyTree> tree;   ///< content read so far; null at first
};

using StudyObserver = std::function<core::Verdict(const StudyProgress&)>;

/// Lists the content of a folder or disc, or of a DICOMDIR (the file or its folder). Reads only headers. Reports
/// damaged files and skips them; Stop keeps what was found. Fails if the folder itself cannot be read.
core::Result<StudyTree> readStudies(const std::string& place, StudyReach reach, const StudyObserver& observe = {});

/// Lists the content of several folders as if they were one; needs at least one folder.
core::Result<StudyTree> readSeriesFolders(const std::vector<std::string>& folders, const StudyObserver& observe = {});

/// Returns true for a file named DICOMDIR.
bool isDicomDirectory(const std::string& path);

}   // namespace angiopose::io
