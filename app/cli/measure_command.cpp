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
    const auto profile = core::measureProfile(*branch);
    return profile ? core::Result<std::string>(io::profileTable(profile.value())) : profile.error();
}

core::Result<std::string> wantedTable(const MeasureArguments& arguments, const core::Case& session)
{
    if (arguments.profileBranchId) {
        return profileOfBranch(*session.vessels.tree, *arguments.profileBranchId);
    }
    if (arguments.writeTargetPoints) {
        return arguments.format == OutputFormat::Json ? io::targetPointJson(session) : io::targetPointTable(session);
    }
    return arguments.writeBranches ? io::branchTable(*session.vessels.tree) : io::measurementTable(session);
}

}   // namespace

int runMeasure(const MeasureArguments& arguments)
{
    const auto loaded = loadCaseForCommand(arguments.casePath, std::nullopt);
    if (!loaded) {
        return reportInputError(loaded.error());
    }
    const auto table = wantedTable(arguments, loaded.value());
    if (!table) {
        return reportInputError(table.error().about(arguments.casePath));
    }
    if (arguments.outputPath.empty()) {
        std::fputs(table.value().c_str(), stdout);
        return exitSuccess;
    }
    if (const auto status = io::writeAtomically(arguments.outputPath, table.value()); !status) {
        return reportInputError(status.error());
    }
    std::printf("%s\n", arguments.outputPath.c_str());
    return exitSuccess;
}

}   // namespace angiopose::app
