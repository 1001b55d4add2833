#pragma once

#include "core/evaluation/trial/run_record.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::core {

/// One setting of an experiment, shown as one block of its tables.
struct Condition {
    std::string id;   ///< id used in files and on the command line, such as "cam-2-5"
    std::string title;   ///< display name in tables
    bool isStandard = true;   ///< whether the condition is included when none is requested
};

/// Creates trial number `trial`; the trial does not depend on the method, the thread or the shard.
using TrialMaker = std::function<Trial(std::uint64_t trial)>;

/// Criterion by which a registration counts as successful.
enum class SuccessCriterion { ProjectionWithin5Px, RayDistanceWithin2Mm, ProjectionWithin1Px };

/// One protocol of ALGORITHMS §4.
struct Protocol {
    std::string_view id;
    std::string_view summary;   ///< description in one sentence
    std::uint64_t defaultTrials = 0;   ///< trials per condition
    int anatomyCount = 1;   ///< number of anatomies; trial k shows anatomy k mod anatomyCount
    SuccessCriterion success = SuccessCriterion::ProjectionWithin5Px;
    std::vector<Condition> conditions;
    TrialMaker (*prepare)(std::size_t condition, std::uint64_t seed) = nullptr;
};

/// Returns the protocols that generate their own trials.
std::span<const Protocol> protocols();

/// Returns the protocol with this id, or null. "own" has no conditions and creates no trials; both come from its runs.
const Protocol* findProtocol(std::string_view id);

/// Parses a comma-separated list of condition ids or of id prefixes that end before a dash ("clean" selects
/// "clean-0-1", …) and returns the indices of the conditions; for an empty list, those of the standard conditions. The
/// error names the entry that matches no condition.
Result<std::vector<std::size_t>> parseConditions(const Protocol& protocol, const std::string& requests);

}   // namespace angiopose::core
