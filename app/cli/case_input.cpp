#include "app/cli/case_input.h"

#include "app/cli/console.h"
#include "app/number_text.h"
#include "io/case_file.h"

#include <algorithm>
#include <charconv>

namespace app {

core::Result<core::RegistrationCase> loadCaseForCommand(const std::string& path, std::optional<int> frame)
{
    std::vector<std::string> warnings;
    auto loaded = io::loadCase(path, warnings);
    printWarnings(warnings);
    if (!loaded || !frame) {
        return loaded;
    }
    core::RegistrationCase registrationCase = std::move(loaded).value();
    const int frameCount = registrationCase.angiogram ? registrationCase.angiogram->frameCount() : 0;
    if (*frame < 0 || *frame >= frameCount) {
        return core::Error{path + ": frame " + std::to_string(*frame) +
                           " does not exist. The angiogram has frames 0 to " + std::to_string(frameCount - 1) + "."};
    }
    registrationCase.frame = *frame;
    return registrationCase;
}

core::Result<double> optionValue(const core::OptionField& field, const std::string& text)
{
    const auto choice = std::find(field.choices.begin(), field.choices.end(), text);
    if (choice != field.choices.end()) {
        return static_cast<double>(choice - field.choices.begin());
    }
    double value = 0.0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    if (parsed.ec != std::errc{} || parsed.ptr != text.data() + text.size()) {
        return core::Error{"Option '" + std::string(field.key) + "' needs a value, not '" + text + "'."};
    }
    if (!(value >= field.min && value <= field.max)) {
        return core::Error{"Option '" + std::string(field.key) + "' must lie between " +
                           fixedText(field.min, field.decimals) + " and " + fixedText(field.max, field.decimals) +
                           ", not " + text + "."};
    }
    return value;
}

}   // namespace app
