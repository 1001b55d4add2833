#include "angiopose/options.h"

#include "app/library/conversions.h"
#include "app/library/observer_adapter.h"
#include "core/geometry/pose_axis.h"
#include "core/registration/methods/method_info.h"
#include "core/registration/options/option_text.h"
#include "core/support/nearest_word.h"
#include "io/support/numbers.h"

#include <algorithm>

namespace angiopose::library {
namespace {

std::string textOf(const core::OptionField& field, const core::OptionValue& value)
{
    const auto* number = std::get_if<double>(&value);
    return number != nullptr ? io::toText(*number) : std::string(core::nameOf(field, value));
}

void checkKey(const std::string& key)
{
    if (core::findOption(key) != nullptr) {
        return;
    }
    std::vector<std::string> keys;
    for (const core::OptionField& field : core::optionFields()) {
        keys.emplace_back(field.key);
    }
    const std::string nearest = core::nearestWord(key, keys);
    throw Error("library.no-option", "There is no option '" + key + "'. " +
                                         (nearest.empty() ? "" : "Did you mean '" + nearest + "'? ") +
                                         "`methods()` lists the options of every method.");
}

OptionInfo infoOf(const core::OptionField& field)
{
    const auto* number = std::get_if<core::NumberOption>(&field.type);
    const core::OptionRange range = core::rangeOf(field);
    const auto names = core::namesOf(field);
    return {std::string(field.key),
            std::string(number != nullptr ? number->unit : ""),
            std::string(field.help),
            range.min,
            range.max,
            {names.begin(), names.end()},
            textOf(field, field.read({}))};
}

}   // namespace

core::RegistrationOptions toCore(const RegistrationOptions& options)
{
    core::RegistrationOptions converted;
    converted.method = options.method;
    for (const auto& [key, value] : options.values) {
        checkKey(key);
        check(core::setOption(converted, key + "=" + value));
    }
    for (const std::string& id : options.locks) {
        const auto axis = core::parsePoseAxis(id);
        if (!axis) {
            throw Error("library.no-lock",
                        "There is no degree of freedom '" + id + "' to lock. Use " + core::poseAxisIds() + ".");
        }
        converted.locks[static_cast<std::size_t>(*axis)] = true;
    }
    return converted;
}

RegistrationOptions toPublic(const core::RegistrationOptions& options)
{
    RegistrationOptions converted;
    converted.method = options.method;
    const core::RegistrationOptions defaults;
    for (const core::OptionField& field : core::optionFields()) {
        if (field.read(options) != field.read(defaults)) {
            converted.values[std::string(field.key)] = textOf(field, field.read(options));
        }
    }
    for (const core::PoseAxis axis : core::poseAxes) {
        if (core::isLocked(options.locks, axis)) {
            converted.locks.emplace_back(core::idOf(axis));
        }
    }
    return converted;
}

}   // namespace angiopose::library

namespace angiopose {

RegistrationOptions& RegistrationOptions::set(const std::string& key, double value)
{
    values[key] = io::toText(value);
    return *this;
}

RegistrationOptions& RegistrationOptions::set(const std::string& key, std::string_view choice)
{
    values[key] = choice;
    return *this;
}

std::vector<MethodInfo> methods()
{
    std::vector<MethodInfo> all;
    for (const core::MethodInfo& method : core::methodInfos()) {
        MethodInfo info{std::string(method.id), std::string(method.label), std::string(method.summary), {}};
        for (const core::OptionField& field : core::optionFields()) {
            if (core::appliesTo(field, method.id)) {
                info.options.push_back(library::infoOf(field));
            }
        }
        all.push_back(std::move(info));
    }
    return all;
}

}   // namespace angiopose
