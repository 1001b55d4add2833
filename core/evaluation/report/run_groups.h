#pragma once

#include "core/evaluation/protocols/protocol.h"
#include "core/evaluation/trial/run_record.h"

#include <functional>
#include <map>

namespace angiopose::core {

using RunValue = double RunRecord::*;

/// Mean projection distance above which a registration is a gross failure: 5 px in simulations, 5 mm in clinical ones.
inline constexpr double grossFailurePx = 5.0;
inline constexpr double grossFailureMm = 5.0;
inline constexpr double successfulMrpdMm = 2.0;

/// Runs of one method under one condition, sorted by trial.
class RunGroup {
public:
    void add(const RunRecord& run) { runs_.push_back(&run); }

    int count() const { return static_cast<int>(runs_.size()); }
    const std::vector<const RunRecord*>& runs() const { return runs_; }
    /// Returns the known values of the runs, including infinite ones; NaN values are unknown and left out.
    std::vector<double> values(RunValue value) const;
    double quantile(RunValue value, double fraction) const;
    double median(RunValue value) const { return quantile(value, 0.5); }
    double mean(RunValue value) const;
    int countIf(const std::function<bool(const RunRecord&)>& predicate) const;
    RunGroup filter(const std::function<bool(const RunRecord&)>& predicate) const;
    RunGroup forAnatomy(int anatomy) const;

private:
    std::vector<const RunRecord*> runs_;
};

/// Runs grouped for tables and plots; the run set must outlive this object.
class RunGroups {
public:
    explicit RunGroups(const RunSet& runs);

    const Protocol& protocol() const { return *protocol_; }
    /// Returns the conditions present in the runs, in the protocol's order, or sorted by id if the protocol has none.
    const std::vector<Condition>& conditions() const { return conditions_; }
    int anatomyCount() const { return anatomyCount_; }   ///< from the protocol, or from the runs if it has no trials
    const std::vector<std::string>& methods() const { return methods_; }   ///< in order of appearance
    const RunGroup& groupOf(const Condition& condition, const std::string& method) const;

private:
    void addOwnConditions();

    const Protocol* protocol_ = nullptr;
    int anatomyCount_ = 1;
    std::vector<Condition> conditions_;
    std::vector<std::string> methods_;
    std::map<std::pair<std::string, std::string>, RunGroup> groups_;
};

bool isGrossFailurePx(const RunRecord& run);
bool isGrossFailureMm(const RunRecord& run);

/// Whether a run is successful by the protocol's criterion.
bool isSuccess(SuccessCriterion criterion, const RunRecord& run);
std::string_view toText(SuccessCriterion criterion);   ///< "mean projection distance at most 5 px", …

}   // namespace angiopose::core
