#include "core/registration/methods/method_info.h"

#include "core/messages/messages.h"
#include "core/registration/methods/method.h"
#include "core/registration/options/option_fields.h"

#include <algorithm>

namespace angiopose::core {
namespace {

std::optional<Message> findProblem(const PoseLocks& locks, const Method& method)
{
    if (std::find(locks.begin(), locks.end(), false) == locks.end()) {
        return messages::allLocked();
    }
    if (isAnyLocked(locks) && !method.respectsLocks) {
        return messages::methodCannotLock(method.info.label);
    }
    return {};
}

}   // namespace

std::span<const MethodInfo> methodInfos()
{
    static const std::vector<MethodInfo> infos = [] {
        std::vector<MethodInfo> all;
        for (const Method& method : methods()) {
            all.push_back(method.info);
        }
        return all;
    }();
    return infos;
}

std::optional<Message> findProblem(const RegistrationOptions& options)
{
    if (findMethod(options.method) == nullptr) {
        std::vector<std::string> known;
        for (const MethodInfo& info : methodInfos()) {
            known.emplace_back(info.id);
        }
        return messages::noSuchMethod(options.method, known);
    }
    for (const OptionField& field : optionFields()) {
        if (!isInRange(field, options)) {
            const OptionRange range = rangeOf(field);
            return messages::optionOutOfRange(field.key, Quantity{range.min, Quantity::significantDigits},
                                              Quantity{range.max, Quantity::significantDigits});
        }
    }
    return findProblem(options.locks, *findMethod(options.method));
}

}   // namespace angiopose::core
