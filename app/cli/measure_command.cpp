#include "app/cli/case_input.h"
#include "app/cli/commands.h"
#include "io/measurement_table.h"

#include <cstdio>

namespace angiopose::app {

int runMeasure(const MeasureArguments& arguments)
{
    const auto loaded = loadCaseForCommand(arguments.casePath, std::nullopt);
    if (!loaded) {
        return failInput(loaded.error());
    }
    if (arguments.outputPath.empty()) {
        std::fputs(io::measurementTable(loaded.value()).c_str(), stdout);
        return exitDone;
    }
    if (const auto status = io::writeMeasurements(loaded.value(), arguments.outputPath); !status) {
        return failInput(status.error());
    }
    std::printf("%s\n", arguments.outputPath.c_str());
    return exitDone;
}

}   // namespace angiopose::app
