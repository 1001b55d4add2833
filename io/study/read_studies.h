#pragma once

#include "core/support/observer_decision.h"
#include "core/support/result.h"
#include "io/study/study_tree.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace angiopose::io {

/// Files to read: those that a DICOMDIR lists, if there is one, or all files of the folder.
enum class StudyScope { Listed, AllFiles };

struct StudyProgress {
    std::size_t read = 0;
    std::size_t found = 0;   ///< number of files found; grows while folders are searched, before any file is read
    std::shared_ptr<const StudyTree> tree;   ///< what has been read so far; initially null
};

using StudyObserver = std::function<core::ObserverDecision(const StudyProgress&)>;

/// Lists the contents of a folder, a disc or a DICOMDIR (given by the file or its folder). Reads only headers. Reports
/// damaged files and skips them. On Stop, returns what was found so far. Fails if the folder itself cannot be read.
core::Result<StudyTree> readStudies(const std::string& location, StudyScope scope, const StudyObserver& observe = {});

/// Lists the contents of several folders as if they were one; at least one folder is required.
core::Result<StudyTree> readSeriesFolders(const std::vector<std::string>& folders, const StudyObserver& observe = {});

/// Returns whether the file is named DICOMDIR.
bool isDicomDirectory(const std::string& path);

}   // namespace angiopose::io
