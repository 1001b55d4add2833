#pragma once

#include "app/jobs/job.h"
#include "core/imaging/image2d.h"
#include "core/registration/picture/drr.h"
#include "core/registration/registration.h"
#include "core/support/result.h"

#include <QObject>

#include <memory>
#include <optional>

namespace angiopose::app {

/// Computes DRRs of the vessels of a case for any pose; the first call prepares the data. Not thread-safe: only one
/// worker may use it at a time.
class DrrSource {
public:
    DrrSource(core::RegistrationInput input, core::RegistrationOptions options);

    /// Returns a DRR with bright vessels on 0, at half the image's resolution. Fails if the input cannot be registered.
    core::Result<core::ImageF> from(const core::RigidTransform& cameraFromPatient);

private:
    core::RegistrationInput input_;
    core::RegistrationOptions options_;
    std::unique_ptr<core::RegistrationProblem> problem_;   ///< must outlive `drr_`, which refers to it
    std::optional<core::Drr> drr_;
};

/// Computes DRRs of the vessels (from the CTA inside them, or from tubes) off the GUI thread, always for the newest
/// pose: a request during a computation replaces any pending one.
class DrrJob : public QObject {
    Q_OBJECT
public:
    explicit DrrJob(QObject* parent = nullptr);

    void setInput(core::RegistrationInput input,
                  core::RegistrationOptions options);   ///< the input is prepared when the next request arrives
    void request(const core::RigidTransform& cameraFromPatient);
    void clear();   ///< drops the pending request, the computation in progress and the input

signals:
    void rendered(const core::ImageF& picture);   ///< emitted with bright vessels on 0, at half the image's resolution
    void failed(const core::Message& reason);

private:
    void cancel();   ///< drops the pending request and the computation in progress
    void start(const core::RigidTransform& cameraFromPatient);
    void startPending();

    std::shared_ptr<DrrSource> source_;
    std::optional<core::RigidTransform> pending_;
    Job<core::ImageF> job_;
};

}   // namespace angiopose::app
