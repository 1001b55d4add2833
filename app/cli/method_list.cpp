#include "app/cli/method_list.h"

#include "core/registration/methods/method_info.h"
#include "core/registration/options/registration_options.h"

namespace angiopose::app {

std::string methodList()
{
    std::string text = "Methods:";
    for (const core::MethodInfo& method : core::methodInfos()) {
        text += "\n  " + std::string(method.id) + "  " + std::string(method.summary);
    }
    return text;
}

}   // namespace angiopose::app
