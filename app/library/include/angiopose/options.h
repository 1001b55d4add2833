#pragma once

#include "angiopose/export.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose {

/// Registration method and its settings, identified by the keys that `methods()` lists. Settings without a value have
/// their defaults. Unknown keys are rejected; settings of other methods are kept but have no effect.
struct RegistrationOptions {
    std::string method = "angiopose";
    std::map<std::string, std::string> values;   ///< number, or name of a choice, keyed by setting
    std::vector<std::string> locks;   ///< locked degrees of freedom: right, up, along-ray, roll, lao-rao, cra-cau

    ANGIOPOSE_EXPORT RegistrationOptions& set(const std::string& key, double value);
    ANGIOPOSE_EXPORT RegistrationOptions& set(const std::string& key, std::string_view choice);
};

/// A setting of a method.
struct OptionInfo {
    std::string key;
    std::string unit;   ///< "px", "mm", "°" or empty
    std::string help;   ///< effect, in one sentence
    double min = 0.0;
    double max = 0.0;
    std::vector<std::string> choices;   ///< allowed values; empty if any number is allowed
    std::string defaultValue;
};

/// A registration method.
struct MethodInfo {
    std::string id;
    std::string label;
    std::string summary;   ///< cost function of the method and its source in the literature
    std::vector<OptionInfo> options;
};

/// Lists all methods, the default method first.
ANGIOPOSE_EXPORT std::vector<MethodInfo> methods();

}   // namespace angiopose
