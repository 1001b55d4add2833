#include "app/cli/open_pair.h"

#include "app/messages/messages.h"
#include "io/opening/assemble_case.h"
#include "io/opening/read_inputs.h"
#include "io/vessel_input_file.h"

namespace angiopose::app {
namespace {

/// Returns how to read the vessels; nullopt if the file alone determines it.
core::Result<std::optional<core::VesselInput>> vesselInputOf(const std::string& path, const io::CaseSettings& settings)
{
    core::Case asked;
    settings.applyTo(asked);
    if (asked.vessels.input == core::VesselInput()) {
        return std::optional<core::VesselInput>();
    }
    const auto kind = io::vesselInputKindOf(path);
    if (!kind) {
        return kind.error();
    }
    asked.vessels.input.kind = kind.value();
    return std::optional(asked.vessels.input);
}

}   // namespace

core::Result<core::Case> openPair(const InputPair& pair, const io::CaseSettings& settings, core::Messages& warnings,
                                  const io::ReadObserver& observe)
{
    io::OpenHints hints;
    auto vessels = vesselInputOf(pair.vesselsPath, settings);
    if (!vessels) {
        return vessels.error();
    }
    hints.vessels = std::move(vessels).value();
    auto read = io::readInputs({pair.vesselsPath, pair.angiogramPath}, hints, observe);
    if (!read) {
        return read.error();
    }
    const io::LoadedInputs inputs = std::move(read).value();
    if (!inputs.offeredSeries.empty()) {
        return core::Error(messages::batchSeveralSeries(inputs.offeredSeries.size()).about(pair.vesselsPath));
    }
    if (inputs.extentInUnknownUnits) {
        return core::Error(
            messages::batchUnitUnclear(core::Quantity{*inputs.extentInUnknownUnits, 1}).about(pair.vesselsPath));
    }
    warnings.insert(warnings.end(), inputs.warnings.begin(), inputs.warnings.end());
    core::Case session = io::assembleCase(core::Case(), inputs);
    settings.applyTo(session);
    return session;
}

}   // namespace angiopose::app
