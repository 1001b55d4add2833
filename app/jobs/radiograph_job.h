#pragma once

#include "app/jobs/job.h"
#include "core/imaging/image2d.h"
#include "core/registration/registration.h"
#include "core/support/result.h"

#include <QObject>

#include <memory>
#include <optional>

namespace angiopose::app {

class RadiographSource;

/// Makes radiographs of the vessels (of the CTA inside them, or of tubes) off the GUI thread, always from the newest
/// pose: a wish while one is being made replaces the waiting one.
class RadiographJob : public QObject {
    Q_OBJECT
public:
    explicit RadiographJob(QObject* parent = nullptr);

    void setInput(core::RegistrationInput input,
                  core::RegistrationOptions options);   ///< made ready with the next wish
    void request(const core::RigidTransform& cameraFromPatient);
    void clear();   ///< drops what waits, what is being made and the input

signals:
    void made(const core::ImageF& picture);   ///< vessels bright on 0, at half the image's resolution
    void failed(const core::Message& reason);

private:
    void cancel();   ///< drops what waits and what is being made
    void start(const core::RigidTransform& cameraFromPatient);
    void startWaiting();

    std::shared_ptr<RadiographSource> source_;
    std::optional<core::RigidTransform> waiting_;
    Job<core::ImageF> job_;
};

}   // namespace angiopose::app