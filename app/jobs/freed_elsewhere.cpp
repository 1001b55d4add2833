#include "app/jobs/freed_elsewhere.h"

namespace angiopose::app {
namespace {

core::RegistrationCase freedElsewhere(core::RegistrationCase read)
{
    read.volume = app::freedElsewhere(std::move(read.volume));
    read.lumen = app::freedElsewhere(std::move(read.lumen));
    read.angiogram = app::freedElsewhere(std::move(read.angiogram));
    read.storedRun = app::freedElsewhere(std::move(read.storedRun));
    for (core::OtherView& other : read.otherViews) {
        if (other.view) {
            other.view = std::make_shared<const core::RegistrationCase>(freedElsewhere(*other.view));
        }
    }
    return read;
}

}   // namespace

LoadedInputs freedElsewhere(LoadedInputs inputs)
{
    inputs.volume = freedElsewhere(std::move(inputs.volume));
    inputs.lumen = freedElsewhere(std::move(inputs.lumen));
    inputs.angiogram = freedElsewhere(std::move(inputs.angiogram));
    if (inputs.wholeCase) {
        inputs.wholeCase = freedElsewhere(*std::move(inputs.wholeCase));
    }
    return inputs;
}

}   // namespace angiopose::app