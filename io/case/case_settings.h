#pragma once

#include "core/case/case.h"
#include "core/support/result.h"

#include <functional>
#include <string>
#include <vector>

namespace angiopose::io {

/// Settings that override values of a case file and are named as in such files: options by key ("preset"), frame
/// tracing ("angiogram.trace.sensitivity") and vessel tracing ("vessel.tracing.threshold").
class CaseSettings {
public:
    /// Adds "name=value"; replaces an earlier assignment to the same name. Names are case-insensitive. Errors list
    /// similar names or the permitted values.
    core::Status add(const std::string& assignment);
    core::Status add(const std::vector<std::string>& assignments);

    bool isEmpty() const { return settings_.empty(); }

    /// Returns the assignments with names as spelled in case files, in alphabetical order.
    std::vector<std::string> assignments() const;

    /// Applies the settings to a case; frame tracing settings apply to all views.
    void applyTo(core::Case& session) const;

private:
    struct Setting {
        std::string name;
        std::string value;
        std::function<void(core::Case&)> apply;
    };
    std::vector<Setting> settings_;   ///< sorted by name
};

std::vector<std::string> caseSettingNames();

}   // namespace angiopose::io
