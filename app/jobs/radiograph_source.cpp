#include "app/jobs/radiograph_source.h"

#include <utility>

namespace angiopose::app {

RadiographSource::RadiographSource(core::RegistrationInput input, core::RegistrationOptions options)
    : input_(std::move(input)), options_(std::move(options))
{
}

core::Result<core::ImageF> RadiographSource::from(const core::RigidTransform& cameraFromPatient)
{
    if (!radiograph_) {
        auto problem = core::makeProblem(input_, options_);
        if (!problem) {
            return problem.error();
        }
        problem_ = std::make_unique<core::RegistrationProblem>(std::move(problem).value());
        radiograph_.emplace(*problem_);
    }
    return radiograph_->from(cameraFromPatient);
}

}   // namespace angiopose::app