#pragma once

#include "core/registration/methods/method_info.h"
#include "core/registration/options/registration_options.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::test {

inline core::RegistrationOptions exactSamplesBy(std::string_view method)
{
    core::RegistrationOptions options;
    options.method = method;
    options.resample = false;
    options.seed.preset = core::PriorPreset::NoPrior;
    return options;
}

inline std::vector<std::string_view> treeMethodIds()
{
    std::vector<std::string_view> ids;
    for (const core::MethodInfo& info : core::methodInfos()) {
        if (info.id != "wire") {   // requires one line, not a tree: see wire_test.cpp
            ids.push_back(info.id);
        }
    }
    return ids;
}

inline std::string methodTestName(const testing::TestParamInfo<std::string_view>& method)
{
    std::string name(method.param);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

}   // namespace angiopose::test
