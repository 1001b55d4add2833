#pragma once

#include "io/study/dicom_directory.h"
#include "io/study/study_file.h"
#include "io/study/study_tree.h"

#include <map>
#include <string>
#include <vector>

namespace angiopose::io {

/// Puts headers together as patients, studies and series; the grouping into volumes and runs is `groupSlices`.
class StudyCollector {
public:
    void add(StudyFile file);
    void addMissing(const ListedFile& file) { missing_.push_back(file); }

    /// Of all that was added so far. Counts of files are the caller's.
    StudyTree tree() const;

private:
    /// What a series is told by beside its images.
    struct Facts {
        std::string studyDescription, bodyPart, imageType, transferSyntax;
        int frames = 1;
        int samples = 1;
        double frameTimeMs = 0.0;
    };

    std::vector<StudySeries> seriesWithImages() const;
    std::vector<StudySeries> seriesWithoutImages() const;
    void noteMissing(std::vector<StudySeries>& all) const;
    void judge(StudySeries& series, const Facts& facts) const;
    const Facts* factsOf(const std::string& path) const;
    std::string studyDescriptionOf(const StudySeries& series) const;

    std::vector<DicomImages> images_;
    std::vector<DicomImages> withoutImage_;   ///< reports and the like, each with the path of its file
    std::map<std::string, Facts> facts_;   ///< by path
    std::vector<ListedFile> missing_;
};

}   // namespace angiopose::io
