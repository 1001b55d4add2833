#pragma once

#include "app/jobs/job.h"

#include <functional>
#include <optional>
#include <utility>

namespace angiopose::app {

/// Work off the window's thread on the newest of many wishes: one that comes while another is worked on waits, and
/// takes the place of the one that waited.
template <class Wish, class Found>
class NewestJob {
public:
    using Work = std::function<core::Result<Found>(const Wish&, JobLink<double>&)>;

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

    void request(Wish wish)
    {
        if (job_.isRunning()) {
            waiting_ = std::move(wish);
        } else if (work_) {
            start(std::move(wish));
        }
    }
    /// At once, in place of what is under way.
    void requestInstead(Wish wish)
    {
        drop();
        request(std::move(wish));
    }
    void drop()
    {
        waiting_.reset();
        job_.drop();
    }

private:
    void start(Wish wish)
    {
        job_.start([work = work_, wish = std::move(wish)](JobLink<double>& link) { return work(wish, link); });
    }
    void startWaiting()
    {
        if (auto next = std::exchange(waiting_, std::nullopt)) {
            start(*std::move(next));
        }
    }

    Work work_;
    std::optional<Wish> waiting_;
    Job<Found> job_;
};

}   // namespace angiopose::app
