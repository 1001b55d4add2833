#pragma once

#include "core/support/result.h"
#include "core/support/verdict.h"
#include "io/study/study_tree.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace angiopose::io {

/// Which files are read: those that a DICOMDIR lists where there is one, or all of the folder.
enum class StudyReach { Listed, AllFiles };

struct StudyProgress {
    std::size_t read = 0;
    std::size_t found = 0;   ///< grows while folders are looked through, when nothing is read yet
    std::shared_ptr<const StudyTree> tree;   ///< of what was read so far; null at first
};

using StudyObserver = std::function<core::Verdict(const StudyProgress&)>;

/// What lies in a folder, on a disc, or is listed by a DICOMDIR (the file or its folder). Only headers are read.
/// Damaged files are named and passed by; Stop keeps what was found. Fails when the folder itself cannot be read.
core::Result<StudyTree> readStudies(const std::string& place, StudyReach reach, const StudyObserver& observe = {});

/// What lies in any of these folders, as if in one; at least one of them.
core::Result<StudyTree> readSeriesFolders(const std::vector<std::string>& folders, const StudyObserver& observe = {});

/// True for a file named DICOMDIR.
bool isDicomDirectory(const std::string& path);

}   // namespace angiopose::io
