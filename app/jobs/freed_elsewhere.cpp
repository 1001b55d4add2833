#include "app/jobs/freed_elsewhere.h"

namespace angiopose::app {
namespace {

core::Case freedElsewhere(core::Case read)
{
    read.vessels.scan = app::freedElsewhere(std::move(read.vessels.scan));
    read.vessels.lumen = app::freedElsewhere(std::move(read.vessels.lumen));
    for (core::View& view : read.views) {
        view.angiogram = app::freedElsewhere(std::move(view.angiogram));
        view.storedRun = app::freedElsewhere(std::move(view.storedRun));
    }
    return read;
}

}   // namespace

io::LoadedInputs freedElsewhere(io::LoadedInputs inputs)
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
