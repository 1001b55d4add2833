#include "app/cli/batch/batch_pool.h"

#include "app/cli/batch/batch_row.h"
#include "app/cli/batch/batch_worker.h"
#include "app/cli/console.h"
#include "app/messages/messages.h"
#include "io/support/system/own_process.h"
#include "io/support/system/worker_process.h"

#include <algorithm>
#include <cmath>
#include <exception>

namespace angiopose::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int askedEveryMs = 200;   // polling interval for an interrupt by the user
constexpr auto stopPatience = std::chrono::seconds(2);

std::unique_ptr<io::WorkerProcess> startWorker(int threads)
{
    const std::vector<std::string> arguments{"batch-worker", std::to_string(io::ownProcessId()),
                                             std::to_string(threads)};
    return std::make_unique<io::WorkerProcess>(io::ownBinary().string(), arguments, workerEnvironment(threads));
}

}   // namespace

/// Slot for a worker and its current job.
struct BatchPool::Seat {
    std::unique_ptr<io::WorkerProcess> worker;
    std::optional<std::size_t> job;
    std::optional<Clock::time_point> deadline;
    bool isFresh = true;   ///< true until the worker has finished its first job
};

BatchPool::BatchPool(std::vector<BatchJob> jobs, PoolOptions options) : jobs_(std::move(jobs)), options_(options)
{
    const int count = std::min<int>(std::max(1, options_.workers), static_cast<int>(jobs_.size()));
    for (int i = 0; i < count; ++i) {
        seats_.push_back(std::make_unique<Seat>());
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
        fill();
        std::vector<const io::WorkerProcess*> workers;
        for (const auto& seat : seats_) {
            if (seat->worker) {
                workers.push_back(seat->worker.get());
            }
        }
        io::WorkerProcess::waitForAny(workers, waitMs());
        hearAll();
        endLate();
    }
    return true;
}

bool BatchPool::isDone() const
{
    return next_ == jobs_.size() &&
           std::ranges::none_of(seats_, [](const auto& seat) { return seat->job.has_value(); });
}

void BatchPool::fill()
{
    for (const auto& seat : seats_) {
        while (!seat->job && next_ < jobs_.size()) {
            give(*seat, next_++);
        }
    }
}

void BatchPool::give(Seat& seat, std::size_t job)
{
    seat.job = job;
    if (!seat.worker) {
        seat.worker = startWorker(options_.threadsEach);
        seat.isFresh = true;
    }
    if (!seat.worker->isStarted()) {
        seat.worker.reset();
        const core::Message why = messages::batchNoWorker(io::ownBinary().string());
        settle(seat, abandonedRow(jobs_[job], "crashed", why));
        return;
    }
    if (options_.timeLimitSeconds) {
        seat.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(*options_.timeLimitSeconds));
    }
    seat.worker->tell(lineOf(jobs_[job]));   // if the worker has died, the next read from it detects this
}

void BatchPool::settle(Seat& seat, BatchOutcome outcome)
{
    const std::size_t job = *seat.job;
    seat.job.reset();
    seat.deadline.reset();
    seat.isFresh = false;
    onEnd_(job, std::move(outcome));
}

void BatchPool::hearAll()
{
    for (const auto& seat : seats_) {
        if (seat->worker) {
            hear(*seat);
        }
    }
}

void BatchPool::hear(Seat& seat)
{
    std::string line;
    switch (seat.worker->hear(line)) {
        case io::WorkerProcess::Heard::Nothing:
            return;
        case io::WorkerProcess::Heard::End:
            lose(seat);
            return;
        case io::WorkerProcess::Heard::Line:
            break;
    }
    if (seat.job) {
        settle(seat, outcomeFrom(line));
    }
}

/// Handles a worker that ended. The cause may lie in one of its earlier cases, so the job is repeated in a new worker,
/// unless the ended worker was new itself.
void BatchPool::lose(Seat& seat)
{
    const std::string how = seat.worker->end();
    const bool wasFresh = seat.isFresh;
    seat.worker.reset();
    if (!seat.job) {
        return;
    }
    if (!wasFresh) {
        give(seat, *seat.job);
        return;
    }
    settle(seat, abandonedRow(jobs_[*seat.job], "crashed", messages::batchCrashed(how.empty() ? "killed" : how)));
}

void BatchPool::endLate()
{
    for (const auto& seat : seats_) {
        if (seat->job && seat->deadline && Clock::now() >= *seat->deadline) {
            seat->worker.reset();   // kills the process, because a hung worker reads no requests
            settle(*seat, abandonedRow(jobs_[*seat->job], "out of time",
                                       messages::batchOutOfTime(
                                           core::Quantity{*options_.timeLimitSeconds, core::Quantity::asNeeded, "s"})));
        }
    }
}

int BatchPool::waitMs() const
{
    double ms = askedEveryMs;
    for (const auto& seat : seats_) {
        if (seat->deadline) {
            const std::chrono::duration<double, std::milli> left = *seat->deadline - Clock::now();
            ms = std::min(ms, std::max(0.0, std::ceil(left.count())));
        }
    }
    return static_cast<int>(ms);
}

/// Asks all workers to stop. Outcomes that arrive within `stopPatience` are recorded; workers that do not respond are
/// killed.
void BatchPool::stop()
{
    for (const auto& seat : seats_) {
        if (seat->worker) {
            seat->worker->askToStop();
        }
    }
    const auto end = Clock::now() + stopPatience;
    const auto isRunning = [](const auto& seat) { return seat->worker && seat->job; };
    while (Clock::now() < end && std::ranges::any_of(seats_, isRunning)) {
        std::vector<const io::WorkerProcess*> workers;
        for (const auto& seat : seats_) {
            if (isRunning(seat)) {
                workers.push_back(seat->worker.get());
            }
        }
        io::WorkerProcess::waitForAny(workers, askedEveryMs);
        for (const auto& seat : seats_) {
            std::string line;
            if (!isRunning(seat)) {
                continue;
            }
            const auto heard = seat->worker->hear(line);
            if (heard == io::WorkerProcess::Heard::Line) {
                settle(*seat, outcomeFrom(line));
            } else if (heard == io::WorkerProcess::Heard::End) {
                seat->worker.reset();
            }
        }
    }
    seats_.clear();
}

}   // namespace angiopose::app
