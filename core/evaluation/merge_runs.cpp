#include "core/evaluation/run_experiment.h"
#include "core/messages/messages.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace angiopose::core {
namespace {

/// Sort key of a run: condition in the protocol's order, trial, method in order of appearance.
using RunKey = std::tuple<std::size_t, std::uint64_t, std::size_t>;

std::size_t conditionIndex(const Protocol& protocol, const std::string& id)
{
    const auto found = std::find_if(protocol.conditions.begin(), protocol.conditions.end(),
                                    [&](const Condition& condition) { return condition.id == id; });
    return static_cast<std::size_t>(found - protocol.conditions.begin());
}

/// Whether two records are equal except for their times. Two unknown (NaN) values count as equal.
bool haveEqualResults(const RunRecord& a, const RunRecord& b)
{
    return std::all_of(runFields().begin(), runFields().end(), [&](const RunField& field) {
        const double x = a.*field.value;
        const double y = b.*field.value;
        return field.isTime || x == y || (x != x && y != y);
    });
}

class Merger {
public:
    explicit Merger(const Protocol& protocol) : protocol_(protocol) {}

    Status add(const RunRecord& record)
    {
        const std::size_t condition = conditionIndex(protocol_, record.condition);
        const bool definesConditions = protocol_.conditions.empty();
        if (condition == protocol_.conditions.size() && !definesConditions) {
            return Error(messages::foreignCondition(record.condition, protocol_.id));
        }
        const auto method = methods_.try_emplace(record.method, methods_.size()).first->second;
        const auto [entry, isNew] = runs_.try_emplace({condition, record.trial, method}, record);
        if (!isNew && !haveEqualResults(entry->second, record)) {
            return Error(messages::partsDisagree(record.method, record.trial, record.condition));
        }
        return Done{};
    }

    std::vector<RunRecord> takeRuns()
    {
        std::vector<RunRecord> all;
        for (auto& [entry, record] : runs_) {
            all.push_back(std::move(record));
        }
        return all;
    }

private:
    const Protocol& protocol_;
    std::map<std::string, std::size_t> methods_;
    std::map<RunKey, RunRecord> runs_;
};

}   // namespace

Result<RunSet> mergeRunSets(const std::vector<RunSet>& parts)
{
    const Protocol* protocol = parts.empty() ? nullptr : findProtocol(parts.front().protocol);
    if (protocol == nullptr) {
        return Error(messages::nothingToMerge());
    }
    Merger merger(*protocol);
    for (const RunSet& part : parts) {
        if (part.protocol != parts.front().protocol || part.seed != parts.front().seed) {
            return Error(messages::runsOfDifferentExperiments(
                part.protocol, std::to_string(part.seed), parts.front().protocol, std::to_string(parts.front().seed)));
        }
        for (const RunRecord& record : part.runs) {
            if (const Status status = merger.add(record); !status) {
                return status.error();
            }
        }
    }
    return RunSet{parts.front().protocol, parts.front().seed, merger.takeRuns()};
}

}   // namespace angiopose::core
