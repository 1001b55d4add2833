#include "core/registration/registration_options.h"

#include <gtest/gtest.h>
#include <limits>
#include <set>

namespace angiopose::core {
namespace {

TEST(RegistrationOptions, DefaultsAreFineForEveryMethod)
{
    ASSERT_FALSE(methodInfos().empty());
    EXPECT_EQ(methodInfos().front().id, RegistrationOptions{}.method);
    for (const MethodInfo& info : methodInfos()) {
        RegistrationOptions options;
        options.method = info.id;
        EXPECT_FALSE(findProblem(options)) << info.id;
    }
}

TEST(RegistrationOptions, EveryFieldWritesWhatItReads)
{
    std::set<std::string_view> keys;
    for (const OptionField& field : optionFields()) {
        EXPECT_TRUE(keys.insert(field.key).second) << field.key << " occurs twice";
        EXPECT_FALSE(field.label.empty() || field.help.empty()) << field.key;
        for (const double value : {field.min, field.max}) {
            RegistrationOptions options;
            field.write(options, value);
            EXPECT_DOUBLE_EQ(field.read(options), value) << field.key;
            EXPECT_FALSE(findProblem(options)) << field.key;
        }
    }
}

TEST(RegistrationOptions, NamesTheFieldThatIsOutOfRange)
{
    for (const OptionField& field : optionFields()) {
        RegistrationOptions options;
        field.write(options, field.max + 1.0);
        EXPECT_NE(findProblem(options)->text().find(field.key), std::string::npos) << field.key;
    }
    RegistrationOptions options;
    options.finalScalePx = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(findProblem(options)->text(), "The option finalScalePx is out of range. Give a number from 0.1 to 20.");
}

}   // namespace
}   // namespace angiopose::core