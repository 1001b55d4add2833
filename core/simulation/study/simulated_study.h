#pragma once

#include "core/simulation/simulated_case.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace angiopose::core {

/// Trees of a study: grown ones, or one that is given.
struct StudyTree {
    int count = 1;   ///< so many grown trees; of a given tree 1
    TreeOptions grown;
    std::shared_ptr<const VesselTree> given;   ///< null: grown
};

/// How wrong headers are: standard deviations. The image is formed with the true values.
struct HeaderErrors {
    double distancePercent = 0.0;   ///< of both distances, each for itself
    double spacingPercent = 0.0;   ///< of the pixel spacing
    double angleDeg = 0.0;   ///< of both angles, beside what simulateCase makes them off
};

/// What the images of one part of a study show.
struct StudySetting {
    std::string name;   ///< of its folder and condition
    DsaOptions dsa;
    HeaderErrors header;
};

/// A whole study: every setting shows `casesPerSetting` cases, going round through the trees. The same study, the same
/// bits, case by case.
struct SimulatedStudy {
    std::string name;
    std::uint64_t seed = 1;
    int casesPerSetting = 1;
    std::vector<StudyTree> trees;
    std::vector<StudySetting> settings;

    std::size_t caseCount() const { return settings.size() * static_cast<std::size_t>(casesPerSetting); }
    std::size_t treeCount() const;
};

/// Which setting and tree a case shows, and which number it has within its setting, from 0.
struct StudyPlace {
    std::size_t setting = 0;
    std::size_t number = 0;
    std::size_t tree = 0;
};
StudyPlace placeOf(const SimulatedStudy& study, std::size_t index);

/// The case with that index; cases of one number show the same view and tree in every setting.
SimulatedCase simulateStudyCase(const SimulatedStudy& study, std::size_t index);

/// What of a study cannot be simulated, naming the setting or tree; empty when all can.
std::optional<Message> findProblem(const SimulatedStudy& study);

}   // namespace angiopose::core
