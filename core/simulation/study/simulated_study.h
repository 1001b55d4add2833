#pragma once

#include "core/simulation/simulated_case.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace angiopose::core {

/// Trees of a study: generated trees with common options, or one given tree.
struct StudyTree {
    int count = 1;   ///< number of generated trees; 1 for a given tree
    TreeOptions grown;
    std::shared_ptr<const VesselTree> given;   ///< null for generated trees
};

/// Standard deviations of the header errors. The image is formed with the true values.
struct HeaderErrors {
    double distancePercent = 0.0;   ///< relative error of each of the two source distances, independently
    double spacingPercent = 0.0;   ///< relative error of the pixel spacing
    double angleDeg = 0.0;   ///< error of both gantry angles, in addition to the errors of simulateCase
};

/// Image and header options of one part of a study.
struct StudySetting {
    std::string name;   ///< name of the setting, its folder and its condition
    DsaOptions dsa;
    HeaderErrors header;
};

/// A whole study: every setting has `casesPerSetting` cases, which cycle through the trees. Bitwise reproducible.
struct SimulatedStudy {
    std::string name;
    std::uint64_t seed = 1;
    int casesPerSetting = 1;
    std::vector<StudyTree> trees;
    std::vector<StudySetting> settings;

    std::size_t caseCount() const { return settings.size() * static_cast<std::size_t>(casesPerSetting); }
    std::size_t treeCount() const;
};

/// Setting and tree of a case, and the number of the case within its setting, starting at 0.
struct StudyCase {
    std::size_t setting = 0;
    std::size_t number = 0;
    std::size_t tree = 0;
};
StudyCase studyCaseOf(const SimulatedStudy& study, std::size_t index);

/// Simulates the case with this index. In every setting, cases with the same number show the same view and tree.
SimulatedCase simulateStudyCase(const SimulatedStudy& study, std::size_t index);

/// Returns a message about the setting or tree of a study that cannot be simulated; nullopt if all can.
std::optional<Message> findProblem(const SimulatedStudy& study);

}   // namespace angiopose::core
