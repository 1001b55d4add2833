#include "app/cli/deidentify_options.h"

#include "io/messages/messages.h"
#include "io/support/input_bytes.h"

namespace angiopose::app {
namespace {

constexpr std::size_t minKeyBytes = 16;

}   // namespace

std::shared_ptr<DeidentifyArguments> addDeidentifyOptions(CLI::App& command)
{
    auto arguments = std::make_shared<DeidentifyArguments>();
    auto* wanted = command.add_flag(
        "--deidentify", arguments->isRequested,
        "Remove names, IDs, dates, private elements and free text; replace UIDs and the patient's name and ID");
    command
        .add_option("--dates", arguments->dates,
                    "Whether to remove dates or to shift them by the same amount for all files of a patient")
        ->check(CLI::IsMember({"removed", "shifted"}))
        ->needs(wanted);
    command
        .add_flag("--black-out", arguments->maskBurnedInText,
                  "Mask burned-in text in projection images instead of only reporting it")
        ->needs(wanted);
    command
        .add_option("--pseudonym", arguments->patientName,
                    "Replacement for the patient's name and ID (default: generated)")
        ->needs(wanted);
    command
        .add_option("--key", arguments->keyPath,
                    "File with at least 16 secret bytes; pseudonyms are consistent across exports with the same key "
                    "(default: a new key)")
        ->needs(wanted);
    return arguments;
}

std::optional<io::DeidentificationOptions> deidentificationOf(const DeidentifyArguments& arguments)
{
    if (!arguments.isRequested) {
        return {};
    }
    return io::DeidentificationOptions{
        arguments.dates == "shifted" ? io::DatePolicy::Shifted : io::DatePolicy::None,
        arguments.maskBurnedInText ? io::BurnedInTextPolicy::Masked : io::BurnedInTextPolicy::Reported,
        arguments.patientName};
}

core::Result<io::Pseudonyms> pseudonymsOf(const DeidentifyArguments& arguments)
{
    if (arguments.keyPath.empty()) {
        return io::Pseudonyms::create();
    }
    const auto key = io::openInput(arguments.keyPath);
    if (!key) {
        return key.error();
    }
    const std::string_view bytes = key.value().view();
    return bytes.size() < minKeyBytes
               ? core::Result<io::Pseudonyms>(core::Error(io::messages::keyTooShort().about(arguments.keyPath)))
               : io::Pseudonyms(std::string(bytes));
}

}   // namespace angiopose::app
