#pragma once

#include "app/jobs/job.h"

#include <functional>
#include <optional>
#include <utility>

namespace angiopose::app {

/// Work off the window's thread on the newest of many wishes: one that comes while another is worked on waits, and
/// takes the place of the one that waited.
template <class Request, class Found>
class NewestJob {
public:
    using Work = std::function<core::Result<Found>(const Request&, JobLink<double>&)>;

    /// `made`: each on the thread that made the job. What fails is merely not shown.
    explicit NewestJob(std::function<void(const Found&)> made)
        : job_({[this, made = std::move(made)](const Found& found) {
                    startWaiting();
                    made(found);
                },
                [this](const core::Error&) { startWaiting(); }})
    {
    }

    /// From now on; gets what it needs by value. What is under way is dropped.
    void setWork(Work work)
    {
        drop();
        work_ = std::move(work);
    }
    void clear() { setWork({}); }

    void request(Request wanted)
    {
        if (job_.isRunning()) {
            waiting_ = std::move(wanted);
        } else if (work_) {
            start(std::move(wanted));
        }
    }
    /// At once, in place of what is under way.
    void requestInstead(Request wanted)
    {
        drop();
        request(std::move(wanted));
    }
    void drop()
    {
        waiting_.reset();
        job_.drop();
    }

private:
    void start(Request wanted)
    {
        job_.start([work = work_, wanted = std::move(wanted)](JobLink<double>& link) { return work(wanted, link); });
    }
    void startWaiting()
    {
        if (auto next = std::exchange(waiting_, std::nullopt)) {
            start(*std::move(next));
        }
    }

    Work work_;
    std::optional<Request> waiting_;
    Job<Found> job_;
};

}   // namespace angiopose::app
