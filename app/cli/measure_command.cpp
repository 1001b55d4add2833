#include "app/cli/case_input.h"
#include "app/cli/commands.h"
#include "core/messages/messages.h"
#include "io/branch_table.h"
#include "io/measurement_table.h"
#include "io/support/atomic_file.h"
#include "io/target_point_table.h"

#include <cstdio>

namespace angiopose::app {
namespace {

core::Result<std::string> profileOfBranch(const core::VesselTree& tree, int branchId)
{
    const core::VesselBranch* branch = tree.find(branchId);
    if (!branch) {
        return core::Error(core::messages::noSuchBranch(branchId));
    }
    const auto profile = core::profileOf(*branch);
    return profile ? core::Result<std::string>(io::profileTable(profile.value())) : profile.error();
}

core::Result<std::string> wantedTable(const MeasureArguments& arguments, const core::Case& session)
{
    if (arguments.profiledBranch) {
        return profileOfBranch(*session.vessels.tree, *arguments.profiledBranch);
    }
    if (arguments.areCheckPointsWanted) {
        return arguments.format == OutputFormat::Json ? io::checkPointJson(session) : io::checkPointTable(session);
    }
    return arguments.areBranchesWanted ? io::branchTable(*session.vessels.tree) : io::measurementTable(session);
}

}   // namespace

int runMeasure(const MeasureArguments& arguments)
{
    const auto loaded = loadCaseForCommand(arguments.casePath, std::nullopt);
    if (!loaded) {
        return failInput(loaded.error());
    }
    const auto table = wantedTable(arguments, loaded.value());
    if (!table) {
        return failInput(table.error().about(arguments.casePath));
    }
    if (arguments.outputPath.empty()) {
        std::fputs(table.value().c_str(), stdout);
        return exitDone;
    }
    if (const auto status = io::writeAtomically(arguments.outputPath, table.value()); !status) {
        return failInput(status.error());
    }
    std::printf("%s\n", arguments.outputPath.c_str());
    return exitDone;
}

}   // namespace angiopose::app
