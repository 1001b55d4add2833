#pragma once

#include "core/evaluation/trial/run_record.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::core {

/// One setting of an experiment: a block of its tables.
struct Condition {
    std::string id;   ///< in files and on the command line: "cam-2-5"
    std::string title;   ///< in tables
    bool isStandard = true;   ///< run when no condition is asked for
};

/// Makes trial number `trial`; the same for every method, thread and shard.
using TrialMaker = std::function<Trial(std::uint64_t trial)>;

/// What counts as success.
enum class Success { ProjectionWithin5Px, RayDistanceWithin2Mm, ProjectionWithin1Px };

/// One protocol of ALGORITHMS §4.
struct Protocol {
    std::string_view id;
    std::string_view summary;   ///< one sentence
    std::uint64_t defaultTrials = 0;   ///< of each condition
    int anatomyCount = 1;   ///< trial k shows anatomy k mod anatomyCount
    Success success = Success::ProjectionWithin5Px;
    std::vector<Condition> conditions;
    TrialMaker (*prepare)(std::size_t condition, std::uint64_t seed) = nullptr;
};

/// Those that make their trials.
std::span<const Protocol> protocols();

/// The protocol with this id, or null. "own" has no conditions and makes no trials: its runs bring theirs.
const Protocol* findProtocol(std::string_view id);

/// Indices of the conditions in a comma-separated list of ids or their beginnings up to a dash ("clean" is all of
/// "clean-0-1", …); the standard ones when the list is empty. Fails naming what no condition is called.
Result<std::vector<std::size_t>> conditionsFrom(const Protocol& protocol, const std::string& requests);

}   // namespace angiopose::core