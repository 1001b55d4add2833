#pragma once

#include "core/registration/picture/radiograph.h"
#include "core/registration/registration.h"

#include <memory>
#include <optional>

namespace angiopose::app {

/// The vessels of a case, X-rayed from any pose; made ready with the first. Used by one worker at a time.
class RadiographSource {
public:
    RadiographSource(core::RegistrationInput input, core::RegistrationOptions options);

    /// Vessels bright on 0, at half the image's resolution. Fails on what cannot be registered either.
    core::Result<core::ImageF> from(const core::RigidTransform& cameraFromPatient);

private:
    core::RegistrationInput input_;
    core::RegistrationOptions options_;
    std::unique_ptr<core::RegistrationProblem> problem_;   ///< the radiograph looks into it
    std::optional<core::Radiograph> radiograph_;
};

}   // namespace angiopose::app