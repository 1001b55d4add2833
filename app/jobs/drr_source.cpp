#include "app/jobs/drr_source.h"

#include <utility>

namespace angiopose::app {

DrrSource::DrrSource(core::RegistrationInput input, core::RegistrationOptions options)
    : input_(std::move(input)), options_(std::move(options))
{
}

core::Result<core::ImageF> DrrSource::from(const core::RigidTransform& cameraFromPatient)
{
    if (!drr_) {
        auto problem = core::makeProblem(input_, options_);
        if (!problem) {
            return problem.error();
        }
        problem_ = std::make_unique<core::RegistrationProblem>(std::move(problem).value());
        drr_.emplace(*problem_);
    }
    return drr_->from(cameraFromPatient);
}

}   // namespace angiopose::app
