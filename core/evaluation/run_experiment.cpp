#include "core/evaluation/run_experiment.h"

#include "core/evaluation/trial/evaluated_method.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

namespace angiopose::core {
namespace {

constexpr std::uint64_t trialsWithHistory = 48;   ///< per condition; enough for a median curve

struct Task {
    std::size_t condition = 0;   ///< index into the conditions of the plan
    std::uint64_t trial = 0;
};

std::vector<Task> tasksOf(const ExperimentPlan& plan)
{
    std::vector<Task> tasks;
    for (std::size_t c = 0; c < plan.conditions.size(); ++c) {
        for (std::uint64_t trial = plan.shard.index; trial < plan.trials; trial += plan.shard.count) {
            tasks.push_back({c, trial});
        }
    }
    return tasks;
}

/// Distributes the tasks over threads and collects their results.
class WorkerPool {
public:
    WorkerPool(const ExperimentPlan& plan, const ExperimentObserver& observe)
        : plan_(plan), observe_(observe), tasks_(tasksOf(plan)), records_(tasks_.size())
    {
        for (const std::size_t condition : plan.conditions) {
            makers_.push_back(plan.protocol->prepare(condition, plan.seed));
        }
    }

    void work()
    {
        for (std::size_t i = next_++; i < tasks_.size() && !isStopped_; i = next_++) {
            records_[i] = runTask(tasks_[i]);
            reportProgress();
        }
    }

    Experiment takeExperiment()
    {
        Experiment experiment{{std::string(plan_.protocol->id), plan_.seed, {}}, isStopped_};
        for (std::vector<RunRecord>& records : records_) {
            std::move(records.begin(), records.end(), std::back_inserter(experiment.runs.runs));
        }
        return experiment;
    }

private:
    /// Returns the records of all methods; empty if the experiment was stopped before the last method finished.
    std::vector<RunRecord> runTask(const Task& task)
    {
        const Trial trial = makers_[task.condition](task.trial);
        const KeepHistory keepHistory = task.trial < trialsWithHistory ? KeepHistory::Yes : KeepHistory::No;
        std::vector<RunRecord> records;
        for (const EvaluatedMethod& evaluatedMethod : plan_.evaluatedMethods) {
            auto record = isStopped_
                              ? std::nullopt
                              : runTrial(trial, evaluatedMethod, keepHistory, [this] { return isStopped_.load(); });
            if (!record) {
                return {};
            }
            record->condition = plan_.protocol->conditions[plan_.conditions[task.condition]].id;
            record->trial = task.trial;
            record->anatomy = static_cast<int>(task.trial % static_cast<std::uint64_t>(plan_.protocol->anatomyCount));
            records.push_back(std::move(*record));
        }
        return records;
    }

    void reportProgress()
    {
        const std::lock_guard lock(reportMutex_);
        ++done_;
        if (observe_ && observe_(done_, tasks_.size()) == ObserverDecision::Stop) {
            isStopped_ = true;
        }
    }

    const ExperimentPlan& plan_;
    const ExperimentObserver& observe_;
    std::vector<Task> tasks_;
    std::vector<std::vector<RunRecord>> records_;   ///< one per task, so the results do not depend on thread order
    std::vector<TrialMaker> makers_;
    std::atomic<std::size_t> next_{0};
    std::atomic<bool> isStopped_{false};
    std::mutex reportMutex_;
    std::uint64_t done_ = 0;
};

}   // namespace

Experiment runExperiment(const ExperimentPlan& plan, const ExperimentObserver& observe)
{
    WorkerPool pool(plan, observe);
    {
        std::vector<std::jthread> threads;
        for (int k = 1; k < plan.threads; ++k) {
            threads.emplace_back([&pool] { pool.work(); });
        }
        pool.work();
    }
    return pool.takeExperiment();
}

}   // namespace angiopose::core
