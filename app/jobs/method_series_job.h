#pragma once

#include "app/jobs/job.h"
#include "core/registration/registration.h"
#include "core/support/result.h"

#include <QObject>

#include <string>
#include <vector>

namespace angiopose::app {

/// Runs several registration methods one after the other off the GUI thread, each from the same input with its default
/// or the given options. The signals are emitted on the thread that owns the job.
class MethodSeriesJob : public QObject {
    Q_OBJECT
public:
    explicit MethodSeriesJob(QObject* parent = nullptr);

    void start(core::RegistrationInput input, core::RegistrationOptions options, std::vector<std::string> methodIds);
    void requestStop();   ///< returns at once; the job then emits `ended`
    bool isRunning() const { return job_.isRunning(); }

signals:
    void progressed(const QString& methodId, double progress);   ///< `progress` covers all methods, 0…1
    void solved(const core::RegistrationResult& result);   ///< emitted for each completed method
    void failed(const QString& methodId, const core::Message& reason);   ///< the job continues with the next method
    void ended(bool wasStopped);

private:
    /// Outcome of one method.
    struct MethodOutcome {
        std::string methodId;
        core::Result<core::RegistrationResult> outcome;
    };
    /// Progress of the series, and the outcomes of all methods that have ended so far.
    struct Report {
        std::string methodId;
        double progress = 0.0;
        std::vector<MethodOutcome> ended;
    };
    static core::Result<core::Done> solve(const core::RegistrationInput& input, core::RegistrationOptions options,
                                          const std::vector<std::string>& methodIds, JobLink<Report>& link);
    void tell(const Report& report);

    std::size_t reportedCount_ = 0;   ///< number of ended methods already reported
    bool stopRequested_ = false;
    Job<core::Done, Report> job_;
};

}   // namespace angiopose::app
