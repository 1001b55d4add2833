#pragma once

#include "app/jobs/job.h"

#include <functional>
#include <optional>
#include <utility>

namespace angiopose::app {

/// Processes the newest of many requests off the GUI thread: a request made while another is being processed replaces
/// any pending one.
template <class Request, class Found>
class NewestJob {
public:
    using Work = std::function<core::Result<Found>(const Request&, JobLink<double>&)>;

    /// Calls `made` with each result on the thread that created the job. Failures are ignored.
    explicit NewestJob(std::function<void(const Found&)> made)
        : job_({[this, made = std::move(made)](const Found& found) {
                    startPending();
                    made(found);
                },
                [this](const core::Error&) { startPending(); }})
    {
    }

    /// Sets the work for all further requests, which receives its data by value. Abandons work in progress.
    void setWork(Work work)
    {
        drop();
        work_ = std::move(work);
    }
    void clear() { setWork({}); }

    void request(Request wanted)
    {
        if (job_.isRunning()) {
            pending_ = std::move(wanted);
        } else if (work_) {
            start(std::move(wanted));
        }
    }
    /// Abandons the request in progress and starts this one at once.
    void replaceWith(Request wanted)
    {
        drop();
        request(std::move(wanted));
    }
    void drop()
    {
        pending_.reset();
        job_.drop();
    }

private:
    void start(Request wanted)
    {
        job_.start([work = work_, wanted = std::move(wanted)](JobLink<double>& link) { return work(wanted, link); });
    }
    void startPending()
    {
        if (auto next = std::exchange(pending_, std::nullopt)) {
            start(*std::move(next));
        }
    }

    Work work_;
    std::optional<Request> pending_;
    Job<Found> job_;
};

}   // namespace angiopose::app
