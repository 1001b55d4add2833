#include "app/cli/batch/batch_pool.h"

#include "app/cli/batch/batch_row.h"
#include "app/cli/console.h"
#include "app/messages/messages.h"
#include "io/support/system/current_process.h"
#include "io/support/system/worker_process.h"

#include <algorithm>
#include <cmath>

namespace angiopose::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int askedEveryMs = 200;   // interval between checks for an interrupt by the user
constexpr auto stopPatience = std::chrono::seconds(2);

/// Returns the environment of a worker: the thread count for libraries that read it from a variable, and allocator
/// settings that keep memory between cases instead of returning it to the system.
std::vector<std::string> workerEnvironment(int threads)
{
    std::vector<std::string> environment{"MALLOC_MMAP_THRESHOLD_=67108864", "MALLOC_TRIM_THRESHOLD_=268435456",
                                         "MALLOC_ARENA_MAX=2"};
    for (const char* name :
         {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "ITK_GLOBAL_DEFAULT_NUMBER_OF_THREADS", "VTK_SMP_MAX_THREADS"}) {
        environment.push_back(std::string(name) + "=" + std::to_string(threads));
    }
    return environment;
}

std::unique_ptr<io::WorkerProcess> startWorker(int threads)
{
    const std::vector<std::string> arguments{"batch-worker", std::to_string(io::currentProcessId()),
                                             std::to_string(threads)};
    return std::make_unique<io::WorkerProcess>(io::currentBinaryPath().string(), arguments, workerEnvironment(threads));
}

}   // namespace

/// Slot of a worker, with its current job.
struct BatchPool::WorkerSlot {
    std::unique_ptr<io::WorkerProcess> worker;
    std::optional<std::size_t> job;
    std::optional<Clock::time_point> deadline;
    bool isFresh = true;   ///< true until the worker has finished its first job
};

BatchPool::BatchPool(std::vector<BatchJob> jobs, PoolOptions options) : jobs_(std::move(jobs)), options_(options)
{
    const int count = std::min<int>(std::max(1, options_.workers), static_cast<int>(jobs_.size()));
    for (int i = 0; i < count; ++i) {
        slots_.push_back(std::make_unique<WorkerSlot>());
    }
}

BatchPool::~BatchPool() = default;

bool BatchPool::run(const std::function<void(std::size_t job, BatchOutcome outcome)>& onEnd)
{
    onEnd_ = onEnd;
    while (!isDone()) {
        if (isInterrupted()) {
            stop();
            return false;
        }
        assignJobs();
        std::vector<const io::WorkerProcess*> workers;
        for (const auto& slot : slots_) {
            if (slot->worker) {
                workers.push_back(slot->worker.get());
            }
        }
        io::WorkerProcess::waitForAny(workers, waitMs());
        readReplies();
        killOverdueWorkers();
    }
    return true;
}

bool BatchPool::isDone() const
{
    return nextJob_ == jobs_.size() &&
           std::ranges::none_of(slots_, [](const auto& slot) { return slot->job.has_value(); });
}

void BatchPool::assignJobs()
{
    for (const auto& slot : slots_) {
        while (!slot->job && nextJob_ < jobs_.size()) {
            assign(*slot, nextJob_++);
        }
    }
}

void BatchPool::assign(WorkerSlot& slot, std::size_t job)
{
    slot.job = job;
    if (!slot.worker) {
        slot.worker = startWorker(options_.threadsPerWorker);
        slot.isFresh = true;
    }
    if (!slot.worker->isStarted()) {
        slot.worker.reset();
        const core::Message reason = messages::batchNoWorker(io::currentBinaryPath().string());
        finishJob(slot, makeAbandonedOutcome(jobs_[job], "crashed", reason));
        return;
    }
    if (options_.timeLimitSeconds) {
        slot.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(*options_.timeLimitSeconds));
    }
    slot.worker->sendLine(toJsonLine(jobs_[job]));   // if the worker has died, the next read detects this
}

void BatchPool::finishJob(WorkerSlot& slot, BatchOutcome outcome)
{
    const std::size_t job = *slot.job;
    slot.job.reset();
    slot.deadline.reset();
    slot.isFresh = false;
    onEnd_(job, std::move(outcome));
}

void BatchPool::readReplies()
{
    for (const auto& slot : slots_) {
        if (slot->worker) {
            receiveLine(*slot);
        }
    }
}

void BatchPool::receiveLine(WorkerSlot& slot)
{
    std::string line;
    switch (slot.worker->receiveLine(line)) {
        case io::WorkerProcess::ReadStatus::Nothing:
            return;
        case io::WorkerProcess::ReadStatus::End:
            handleWorkerExit(slot);
            return;
        case io::WorkerProcess::ReadStatus::Line:
            break;
    }
    if (slot.job) {
        finishJob(slot, parseOutcome(line));
    }
}

/// Handles a worker that ended. The cause may lie in one of its earlier cases, so the job is repeated in a new worker
/// unless the ended one was itself new.
void BatchPool::handleWorkerExit(WorkerSlot& slot)
{
    const std::string how = slot.worker->end();
    const bool wasFresh = slot.isFresh;
    slot.worker.reset();
    if (!slot.job) {
        return;
    }
    if (!wasFresh) {
        assign(slot, *slot.job);
        return;
    }
    finishJob(slot,
              makeAbandonedOutcome(jobs_[*slot.job], "crashed", messages::batchCrashed(how.empty() ? "killed" : how)));
}

void BatchPool::killOverdueWorkers()
{
    for (const auto& slot : slots_) {
        if (slot->job && slot->deadline && Clock::now() >= *slot->deadline) {
            slot->worker.reset();   // kills the process, because a hung worker reads no requests
            finishJob(*slot,
                      makeAbandonedOutcome(jobs_[*slot->job], "out of time",
                                           messages::batchOutOfTime(core::Quantity{
                                               *options_.timeLimitSeconds, core::Quantity::significantDigits, "s"})));
        }
    }
}

int BatchPool::waitMs() const
{
    double ms = askedEveryMs;
    for (const auto& slot : slots_) {
        if (slot->deadline) {
            const std::chrono::duration<double, std::milli> left = *slot->deadline - Clock::now();
            ms = std::min(ms, std::max(0.0, std::ceil(left.count())));
        }
    }
    return static_cast<int>(ms);
}

/// Requests all workers to stop. Outcomes that arrive within `stopPatience` are recorded; workers that do not respond
/// are killed.
void BatchPool::stop()
{
    for (const auto& slot : slots_) {
        if (slot->worker) {
            slot->worker->requestStop();
        }
    }
    const auto end = Clock::now() + stopPatience;
    const auto isRunning = [](const auto& slot) { return slot->worker && slot->job; };
    while (Clock::now() < end && std::ranges::any_of(slots_, isRunning)) {
        std::vector<const io::WorkerProcess*> workers;
        for (const auto& slot : slots_) {
            if (isRunning(slot)) {
                workers.push_back(slot->worker.get());
            }
        }
        io::WorkerProcess::waitForAny(workers, askedEveryMs);
        for (const auto& slot : slots_) {
            std::string line;
            if (!isRunning(slot)) {
                continue;
            }
            const auto heard = slot->worker->receiveLine(line);
            if (heard == io::WorkerProcess::ReadStatus::Line) {
                finishJob(*slot, parseOutcome(line));
            } else if (heard == io::WorkerProcess::ReadStatus::End) {
                slot->worker.reset();
            }
        }
    }
    slots_.clear();
}

}   // namespace angiopose::app
