#pragma once

#include "app/jobs/job.h"

#include <functional>
#include <optional>
#include <utility>

namespace angiopose::app {

/// Processes the newest of many requests off the GUI thread: a request made while another is being processed replaces
/// any pending one.
template <class Request, class Value>
class NewestJob {
public:
    using Work = std::function<core::Result<Value>(const Request&, JobLink<double>&)>;

    /// Calls `made` with each result on the thread that created the job. Failures are ignored.
    explicit NewestJob(std::function<void(const Value&)> onResult)
        : job_({[this, onResult = std::move(onResult)](const Value& found) {
                    startPending();
                    onResult(found);
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

    void request(Request newest)
    {
        if (job_.isRunning()) {
            pending_ = std::move(newest);
        } else if (work_) {
            start(std::move(newest));
        }
    }
    /// Abandons the request in progress and starts this one at once.
    void replaceWith(Request newest)
    {
        drop();
        request(std::move(newest));
    }
    void drop()
    {
        pending_.reset();
        job_.drop();
    }

private:
    void start(Request newest)
    {
        job_.start([work = work_, newest = std::move(newest)](JobLink<double>& link) { return work(newest, link); });
    }
    void startPending()
    {
        if (auto next = std::exchange(pending_, std::nullopt)) {
            start(*std::move(next));
        }
    }

    Work work_;
    std::optional<Request> pending_;
    Job<Value> job_;
};

}   // namespace angiopose::app
