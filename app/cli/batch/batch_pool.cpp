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
        for (const auto& seat : slots_) {
            if (seat->worker) {
                workers.push_back(seat->worker.get());
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
           std::ranges::none_of(slots_, [](const auto& seat) { return seat->job.has_value(); });
}

void BatchPool::assignJobs()
{
    for (const auto& seat : slots_) {
        while (!seat->job && nextJob_ < jobs_.size()) {
            assign(*seat, nextJob_++);
        }
    }
}

void BatchPool::assign(WorkerSlot& seat, std::size_t job)
{
    seat.job = job;
    if (!seat.worker) {
        seat.worker = startWorker(options_.threadsPerWorker);
        seat.isFresh = true;
    }
    if (!seat.worker->isStarted()) {
        seat.worker.reset();
        const core::Message why = messages::batchNoWorker(io::currentBinaryPath().string());
        finishJob(seat, makeAbandonedOutcome(jobs_[job], "crashed", why));
        return;
    }
    if (options_.timeLimitSeconds) {
        seat.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(*options_.timeLimitSeconds));
    }
    seat.worker->sendLine(toJsonLine(jobs_[job]));   // if the worker has died, the next read detects this
}

void BatchPool::finishJob(WorkerSlot& seat, BatchOutcome outcome)
{
    const std::size_t job = *seat.job;
    seat.job.reset();
    seat.deadline.reset();
    seat.isFresh = false;
    onEnd_(job, std::move(outcome));
}

void BatchPool::readReplies()
{
    for (const auto& seat : slots_) {
        if (seat->worker) {
            receiveLine(*seat);
        }
    }
}

void BatchPool::receiveLine(WorkerSlot& seat)
{
    std::string line;
    switch (seat.worker->receiveLine(line)) {
        case io::WorkerProcess::ReadStatus::Nothing:
            return;
        case io::WorkerProcess::ReadStatus::End:
            handleWorkerExit(seat);
            return;
        case io::WorkerProcess::ReadStatus::Line:
            break;
    }
    if (seat.job) {
        finishJob(seat, parseOutcome(line));
    }
}

/// Handles a worker that ended. The cause may lie in one of its earlier cases, so the job is repeated in a new worker
/// unless the ended one was itself new.
void BatchPool::handleWorkerExit(WorkerSlot& seat)
{
    const std::string how = seat.worker->end();
    const bool wasFresh = seat.isFresh;
    seat.worker.reset();
    if (!seat.job) {
        return;
    }
    if (!wasFresh) {
        assign(seat, *seat.job);
        return;
    }
    finishJob(seat,
              makeAbandonedOutcome(jobs_[*seat.job], "crashed", messages::batchCrashed(how.empty() ? "killed" : how)));
}

void BatchPool::killOverdueWorkers()
{
    for (const auto& seat : slots_) {
        if (seat->job && seat->deadline && Clock::now() >= *seat->deadline) {
            seat->worker.reset();   // kills the process, because a hung worker reads no requests
            finishJob(*seat,
                      makeAbandonedOutcome(jobs_[*seat->job], "out of time",
                                           messages::batchOutOfTime(core::Quantity{
                                               *options_.timeLimitSeconds, core::Quantity::significantDigits, "s"})));
        }
    }
}

int BatchPool::waitMs() const
{
    double ms = askedEveryMs;
    for (const auto& seat : slots_) {
        if (seat->deadline) {
            const std::chrono::duration<double, std::milli> left = *seat->deadline - Clock::now();
            ms = std::min(ms, std::max(0.0, std::ceil(left.count())));
        }
    }
    return static_cast<int>(ms);
}

/// Requests all workers to stop. Outcomes that arrive within `stopPatience` are recorded; workers that do not respond
/// are killed.
void BatchPool::stop()
{
    for (const auto& seat : slots_) {
        if (seat->worker) {
            seat->worker->requestStop();
        }
    }
    const auto end = Clock::now() + stopPatience;
    const auto isRunning = [](const auto& seat) { return seat->worker && seat->job; };
    while (Clock::now() < end && std::ranges::any_of(slots_, isRunning)) {
        std::vector<const io::WorkerProcess*> workers;
        for (const auto& seat : slots_) {
            if (isRunning(seat)) {
                workers.push_back(seat->worker.get());
            }
        }
        io::WorkerProcess::waitForAny(workers, askedEveryMs);
        for (const auto& seat : slots_) {
            std::string line;
            if (!isRunning(seat)) {
                continue;
            }
            const auto heard = seat->worker->receiveLine(line);
            if (heard == io::WorkerProcess::ReadStatus::Line) {
                finishJob(*seat, parseOutcome(line));
            } else if (heard == io::WorkerProcess::ReadStatus::End) {
                seat->worker.reset();
            }
        }
    }
    slots_.clear();
}

}   // namespace angiopose::app
