#pragma once

#include "io/study/dicom_directory.h"
#include "io/study/study_file.h"
#include "io/study/study_tree.h"

#include <map>
#include <string>
#include <vector>

namespace angiopose::io {

/// Groups headers into patients, studies and series. Uses `groupSlices` to group images into volumes and runs.
class StudyCollector {
public:
    void add(StudyFile file);
    void addMissingFile(const DirectoryEntry& file) { missingFiles_.push_back(file); }

    /// Returns the study tree of all files added so far. The caller sets the file counts.
    StudyTree tree() const;

private:
    /// Attributes of a series in addition to its images.
    struct SeriesAttributes {
        std::string studyDescription, bodyPart, imageType, transferSyntax;
        int frames = 1;
        int samples = 1;
        double frameTimeMs = 0.0;
    };

    std::vector<StudySeries> seriesWithImages() const;
    std::vector<StudySeries> seriesWithoutImages() const;
    void countMissingFiles(std::vector<StudySeries>& all) const;
    void determineUse(StudySeries& series, const SeriesAttributes& attributes) const;
    const SeriesAttributes* attributesOf(const std::string& path) const;
    std::string studyDescriptionOf(const StudySeries& series) const;

    std::vector<DicomImages> images_;
    std::vector<DicomImages> withoutImage_;   ///< objects without an image, for example reports, with their file paths
    std::map<std::string, SeriesAttributes> attributes_;   ///< attributes, keyed by file path
    std::vector<DirectoryEntry> missingFiles_;
};

}   // namespace angiopose::io
