#pragma once

#include "app/cli/batch/batch_job.h"
#include "app/cli/batch/batch_outcome.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace angiopose::app {

struct PoolOptions {
    int workers = 1;
    int threadsPerWorker = 1;   ///< threads per worker
    std::optional<double> timeLimitSeconds;   ///< time limit per case, s
};

/// Pool of worker processes that each run cases one after the other. If a worker crashes or is killed at the time
/// limit, only its current case is lost, and a new worker replaces it.
class BatchPool {
public:
    BatchPool(std::vector<BatchJob> jobs, PoolOptions options);
    ~BatchPool();

    /// Calls `onEnd` with the index and the outcome of each job as it finishes. Returns false if the user stopped the
    /// batch; the remaining jobs then have no outcome.
    bool run(const std::function<void(std::size_t job, BatchOutcome outcome)>& onEnd);

private:
    struct WorkerSlot;

    void assignJobs();
    void assign(WorkerSlot& slot, std::size_t job);
    void readReplies();
    void receiveLine(WorkerSlot& slot);
    void handleWorkerExit(WorkerSlot& slot);
    void killOverdueWorkers();
    int waitMs() const;
    void stop();
    bool isDone() const;
    void finishJob(WorkerSlot& slot, BatchOutcome outcome);

    std::vector<BatchJob> jobs_;
    PoolOptions options_;
    std::vector<std::unique_ptr<WorkerSlot>> slots_;
    std::size_t nextJob_ = 0;
    std::function<void(std::size_t, BatchOutcome)> onEnd_;
};

}   // namespace angiopose::app
