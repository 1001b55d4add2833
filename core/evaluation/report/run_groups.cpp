#include "core/evaluation/report/run_groups.h"

#include "core/support/quantile.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace angiopose::core {

std::vector<double> RunGroup::values(RunValue value) const
{
    std::vector<double> known;
    for (const RunRecord* run : runs_) {
        if (!std::isnan(run->*value)) {
            known.push_back(run->*value);
        }
    }
    return known;
}

double RunGroup::quantile(RunValue value, double fraction) const
{
    return core::quantile(values(value), fraction);
}

double RunGroup::mean(RunValue value) const
{
    const std::vector<double> known = values(value);
    return known.empty() ? unknownMeasure
                         : std::accumulate(known.begin(), known.end(), 0.0) / static_cast<double>(known.size());
}

int RunGroup::countIf(const std::function<bool(const RunRecord&)>& predicate) const
{
    return static_cast<int>(
        std::count_if(runs_.begin(), runs_.end(), [&](const RunRecord* run) { return predicate(*run); }));
}

RunGroup RunGroup::filter(const std::function<bool(const RunRecord&)>& predicate) const
{
    RunGroup chosen;
    std::copy_if(runs_.begin(), runs_.end(), std::back_inserter(chosen.runs_),
                 [&](const RunRecord* run) { return predicate(*run); });
    return chosen;
}

RunGroup RunGroup::forAnatomy(int anatomy) const
{
    return filter([anatomy](const RunRecord& run) { return run.anatomy == anatomy; });
}

RunGroups::RunGroups(const RunSet& runs) : protocol_(findProtocol(runs.protocol))
{
    assert(protocol_ != nullptr);
    anatomyCount_ = protocol_->anatomyCount;
    for (const RunRecord& run : runs.runs) {
        groups_[{run.condition, run.method}].add(run);
        if (std::find(methods_.begin(), methods_.end(), run.method) == methods_.end()) {
            methods_.push_back(run.method);
        }
    }
    for (const Condition& condition : protocol_->conditions) {
        if (std::any_of(groups_.begin(), groups_.end(),
                        [&](const auto& group) { return group.first.first == condition.id; })) {
            conditions_.push_back(condition);
        }
    }
    if (protocol_->prepare == nullptr) {
        addOwnConditions();
    }
}

void RunGroups::addOwnConditions()
{
    for (const auto& [place, group] : groups_) {
        if (conditions_.empty() || conditions_.back().id != place.first) {
            conditions_.push_back({place.first, place.first, true});
        }
        for (const RunRecord* run : group.runs()) {
            anatomyCount_ = std::max(anatomyCount_, run->anatomy + 1);
        }
    }
}

const RunGroup& RunGroups::groupOf(const Condition& condition, const std::string& method) const
{
    static const RunGroup none;
    const auto found = groups_.find({condition.id, method});
    return found == groups_.end() ? none : found->second;
}

bool isGrossFailurePx(const RunRecord& run)
{
    return !(run.meanPx <= grossFailurePx);
}

bool isGrossFailureMm(const RunRecord& run)
{
    return !(run.meanMm <= grossFailureMm);
}

bool isSuccess(SuccessCriterion criterion, const RunRecord& run)
{
    switch (criterion) {
        case SuccessCriterion::ProjectionWithin5Px:
            return !isGrossFailurePx(run);
        case SuccessCriterion::RayDistanceWithin2Mm:
            return run.mrpdMm < successfulMrpdMm;
        case SuccessCriterion::ProjectionWithin1Px:
            return run.meanPx <= 1.0;
    }
    return false;
}

std::string_view toText(SuccessCriterion criterion)
{
    switch (criterion) {
        case SuccessCriterion::ProjectionWithin5Px:
            return "mean projection distance at most 5 px";
        case SuccessCriterion::RayDistanceWithin2Mm:
            return "mean distance to the rays (mRPD) below 2 mm";
        case SuccessCriterion::ProjectionWithin1Px:
            return "mean projection distance at most 1 px";
    }
    return "";
}

}   // namespace angiopose::core
