#pragma once

#include "app/jobs/job.h"
#include "core/imaging/image2d.h"
#include "core/registration/registration.h"
#include "core/support/result.h"

#include <QObject>

#include <memory>
#include <optional>

namespace angiopose::app {

class DrrSource;

/// Computes DRRs of the vessels (from the CTA inside them, or from tubes) off the GUI thread, always for the newest
/// pose: a request during a computation replaces the pending one.
class DrrJob : public QObject {
    Q_OBJECT
public:
    explicit DrrJob(QObject* parent = nullptr);

    void setInput(core::RegistrationInput input,
                  core::RegistrationOptions options);   ///< the input is prepared when the next request arrives
    void request(const core::RigidTransform& cameraFromPatient);
    void clear();   ///< drops the pending request, the computation in progress and the input

signals:
    void rendered(const core::ImageF& picture);   ///< vessels bright on 0, at half the image's resolution
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
