#pragma once

#include "core/registration/picture/drr.h"
#include "core/registration/registration.h"

#include <memory>
#include <optional>

namespace angiopose::app {

/// Computes DRRs of the vessels of a case for any pose; the first call prepares the data. Not thread-safe: one worker
/// at a time.
class DrrSource {
public:
    DrrSource(core::RegistrationInput input, core::RegistrationOptions options);

    /// DRR with vessels bright on 0, at half the image's resolution. Fails if the input cannot be registered.
    core::Result<core::ImageF> from(const core::RigidTransform& cameraFromPatient);

private:
    core::RegistrationInput input_;
    core::RegistrationOptions options_;
    std::unique_ptr<core::RegistrationProblem> problem_;   ///< must outlive `drr_`, which refers to it
    std::optional<core::Drr> drr_;
};

}   // namespace angiopose::app
