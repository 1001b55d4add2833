#include "core/registration/registration_options.h"

#include "core/registration/method.h"

#include <algorithm>
#include <locale>
#include <sstream>

namespace angiopose::core {
namespace {

/// "0.2", not "0.200000", in any locale.
std::string plain(double number)
{
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << number;
    return text.str();
}

std::string findProblem(const PoseLocks& locks, const Method& method)
{
    if (std::find(locks.begin(), locks.end(), false) == locks.end()) {
        return "All six degrees of freedom are locked: nothing is left to find. Unlock at least one.";
    }
    if (isAnyLocked(locks) && !method.heedsLocks) {
        return std::string(method.info.label) +
               " solves for all six degrees of freedom at once and cannot keep one. Unlock them, or choose another "
               "method.";
    }
    return {};
}

}   // namespace

std::string findProblem(const RegistrationOptions& options)
{
    if (findMethod(options.method) == nullptr) {
        std::string known;
        for (const MethodInfo& info : methodInfos()) {
            known += (known.empty() ? "" : ", ") + std::string(info.id);
        }
        return "There is no method '" + options.method + "'. Choose one of: " + known + ".";
    }
    for (const OptionField& field : optionFields()) {
        const double value = field.read(options);
        if (!(value >= field.min && value <= field.max)) {
            return "The option " + std::string(field.key) + " is out of range. Give a number from " + plain(field.min) +
                   " to " + plain(field.max) + ".";
        }
    }
    return findProblem(options.locks, *findMethod(options.method));
}

}   // namespace angiopose::core