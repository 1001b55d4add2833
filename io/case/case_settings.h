#pragma once

#include "core/case/case.h"
#include "core/support/result.h"

#include <functional>
#include <string>
#include <vector>

namespace angiopose::io {

/// What is set in a case over what its file says, by the names that case files have for it: an option by its key
/// ("preset"), how frames are traced ("angiogram.trace.sensitivity"), how vessels are ("vessel.tracing.threshold").
class CaseSettings {
public:
    /// Adds "name=value", a later one over an earlier one of the name; capitals do not matter in names. Fails naming
    /// the nearest names, or what the value may be.
    core::Status add(const std::string& assignment);
    core::Status add(const std::vector<std::string>& assignments);

    bool isEmpty() const { return settings_.empty(); }

    /// As added, the names as files have them, in alphabetical order.
    std::vector<std::string> assignments() const;

    /// Frames of all views are traced alike.
    void applyTo(core::Case& session) const;

private:
    struct Setting {
        std::string name;
        std::string value;
        std::function<void(core::Case&)> apply;
    };
    std::vector<Setting> settings_;   ///< by name
};

/// All names.
std::vector<std::string> caseSettingNames();

}   // namespace angiopose::io
