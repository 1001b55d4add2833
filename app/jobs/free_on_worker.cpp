#include "app/jobs/free_on_worker.h"

namespace angiopose::app {
namespace {

core::Case freeOnWorker(core::Case read)
{
    read.vessels.scan = app::freeOnWorker(std::move(read.vessels.scan));
    read.vessels.lumen = app::freeOnWorker(std::move(read.vessels.lumen));
    for (core::View& view : read.views) {
        view.angiogram = app::freeOnWorker(std::move(view.angiogram));
        view.storedRun = app::freeOnWorker(std::move(view.storedRun));
    }
    return read;
}

}   // namespace

io::LoadedInputs freeOnWorker(io::LoadedInputs inputs)
{
    inputs.volume = freeOnWorker(std::move(inputs.volume));
    inputs.lumen = freeOnWorker(std::move(inputs.lumen));
    inputs.angiogram = freeOnWorker(std::move(inputs.angiogram));
    if (inputs.loadedCase) {
        inputs.loadedCase = freeOnWorker(*std::move(inputs.loadedCase));
    }
    return inputs;
}

}   // namespace angiopose::app
