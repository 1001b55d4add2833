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
    int threadsEach = 1;   ///< of one worker
    std::optional<double> timeLimitSeconds;   ///< of one case
};

/// Worker processes that take cases one after the other. One that crashes, or that is killed because its case takes too
/// long, costs that case alone: another takes its place.
class BatchPool {
public:
    BatchPool(std::vector<BatchJob> jobs, PoolOptions options);
    ~BatchPool();

    /// Calls `onEnd` with the number of each job and its outcome, as they end. False where the user stopped it: the
    /// jobs that are left have no outcome.
    bool run(const std::function<void(std::size_t job, BatchOutcome outcome)>& onEnd);

private:
    struct Seat;

    void fill();
    void give(Seat& seat, std::size_t job);
    void hearAll();
    void hear(Seat& seat);
    void lose(Seat& seat);
    void endLate();
    int waitMs() const;
    void stop();
    bool isDone() const;
    void settle(Seat& seat, BatchOutcome outcome);

    std::vector<BatchJob> jobs_;
    PoolOptions options_;
    std::vector<std::unique_ptr<Seat>> seats_;
    std::size_t next_ = 0;
    std::function<void(std::size_t, BatchOutcome)> onEnd_;
};

}   // namespace angiopose::app
