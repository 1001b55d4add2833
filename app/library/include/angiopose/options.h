#pragma once

#include "angiopose/export.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose {

/// Which method solves a registration, and its settings: those of `methods()`, by key. What is not set has its default.
/// A key that no method knows is refused; a setting of another method is kept, and does nothing.
struct RegistrationOptions {
    std::string method = "angiopose";
    std::map<std::string, std::string> values;   ///< a number, or one of the choices by name
    std::vector<std::string> locks;   ///< degrees of freedom kept: right, up, along-ray, roll, lao-rao, cra-cau

    ANGIOPOSE_EXPORT RegistrationOptions& set(const std::string& key, double value);
    ANGIOPOSE_EXPORT RegistrationOptions& set(const std::string& key, std::string_view choice);
};

/// One setting of a method.
struct OptionInfo {
    std::string key;
    std::string unit;   ///< "px", "mm", "°" or empty
    std::string help;   ///< the effect, one sentence
    double min = 0.0;
    double max = 0.0;
    std::vector<std::string> choices;   ///< not empty: the value is one of these
    std::string defaultValue;
};

/// One method of registration.
struct MethodInfo {
    std::string id;
    std::string label;
    std::string summary;   ///< what it minimises, its source
    std::vector<OptionInfo> options;
};

/// Every method, the default first.
ANGIOPOSE_EXPORT std::vector<MethodInfo> methods();

}   // namespace angiopose
