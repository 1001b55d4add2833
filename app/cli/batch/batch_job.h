#pragma once

#include "core/support/result.h"
#include "io/case/batch_manifest.h"
#include "io/case/case_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace angiopose::app {

/// A row of a batch as its worker is told.
struct BatchJob {
    std::string name;
    std::string casePath;   ///< empty: the two inputs
    std::string vesselsPath;
    std::string angiogramPath;
    std::string method;   ///< empty: the case's own
    std::optional<int> frame;   ///< empty: the case's own
    std::vector<std::string> settings;   ///< "name=value" of io::CaseSettings
    std::string folder;   ///< its own in the output
    std::string asked;   ///< all that the outcome depends on besides the inputs, as JSON text; see askedOf
    bool isResumed = false;   ///< an outcome that is as good as a new one stays
    bool isWithoutPictures = false;
};

/// What a row asks for, without the places of files: the same wherever a manifest lies. `common`: for all rows.
std::string askedOf(const io::BatchEntry& entry, const io::CaseSettings& common);

/// Whether outcomes of all rows that ask like that, however they were set in common.
bool isSameRow(const std::string& asked, const std::string& other);
/// Whether two were run with the same settings in common, by the same version.
bool areSetAlike(const std::string& asked, const std::string& other);

BatchJob jobOf(const io::BatchEntry& entry, const io::CaseSettings& common, const std::string& outputFolder);

/// One line.
std::string lineOf(const BatchJob& job);
/// Throws std::exception where it is none.
BatchJob jobFrom(const std::string& line);

}   // namespace angiopose::app
