#include "core/evaluation/run_experiment.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace angiopose::core {
namespace {

/// Where a run belongs: condition in the protocol's order, trial, method in the order of appearance.
using RunPlace = std::tuple<std::size_t, std::uint64_t, std::size_t>;

std::size_t conditionIndex(const Protocol& protocol, const std::string& id)
{
    const auto found = std::find_if(protocol.conditions.begin(), protocol.conditions.end(),
                                    [&](const Condition& condition) { return condition.id == id; });
    return static_cast<std::size_t>(found - protocol.conditions.begin());
}

/// Equal but for the times; the same bits, so that two unknown measures agree too.
bool agree(const RunRecord& a, const RunRecord& b)
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
        if (condition == protocol_.conditions.size()) {
            return Error{"The condition '" + record.condition + "' is not one of '" + std::string(protocol_.id) +
                         "'. Merge runs of this program's version."};
        }
        const auto method = methods_.try_emplace(record.method, methods_.size()).first->second;
        const auto [place, isNew] = runs_.try_emplace({condition, record.trial, method}, record);
        if (!isNew && !agree(place->second, record)) {
            return Error{"Two parts disagree about " + record.method + " in trial " + std::to_string(record.trial) +
                         " of " + record.condition + ". Merge runs of the same program and settings."};
        }
        return Done{};
    }

    std::vector<RunRecord> takeRuns()
    {
        std::vector<RunRecord> all;
        for (auto& [place, record] : runs_) {
            all.push_back(std::move(record));
        }
        return all;
    }

private:
    const Protocol& protocol_;
    std::map<std::string, std::size_t> methods_;
    std::map<RunPlace, RunRecord> runs_;
};

}   // namespace

Result<RunSet> merged(const std::vector<RunSet>& parts)
{
    const Protocol* protocol = parts.empty() ? nullptr : findProtocol(parts.front().protocol);
    if (protocol == nullptr) {
        return Error{"There are no runs to merge."};
    }
    Merger merger(*protocol);
    for (const RunSet& part : parts) {
        if (part.protocol != parts.front().protocol || part.seed != parts.front().seed) {
            return Error{"Runs of '" + part.protocol + "', seed " + std::to_string(part.seed) + ", and of '" +
                         parts.front().protocol + "', seed " + std::to_string(parts.front().seed) +
                         ", do not belong together. Merge parts of one experiment."};
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