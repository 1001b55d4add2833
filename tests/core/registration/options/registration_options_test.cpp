#include "core/registration/methods/method_info.h"
#include "core/registration/options/option_fields.h"
#include "core/registration/options/option_text.h"

#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <vector>

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

std::vector<OptionValue> extremesOf(const OptionField& field)
{
    const OptionRange range = rangeOf(field);
    return {valueFrom(field, range.min).value(), valueFrom(field, range.max).value()};
}

TEST(RegistrationOptions, EveryFieldWritesWhatItReads)
{
    std::set<std::string_view> keys;
    for (const OptionField& field : optionFields()) {
        EXPECT_TRUE(keys.insert(field.key).second) << field.key << " occurs twice";
        EXPECT_FALSE(field.label.empty() || field.help.empty()) << field.key;
        EXPECT_EQ(findOption(field.key), &field);
        for (const OptionValue& value : extremesOf(field)) {
            RegistrationOptions options;
            field.write(options, value);
            EXPECT_EQ(field.read(options), value) << field.key;
            EXPECT_FALSE(findProblem(options)) << field.key;
        }
    }
    EXPECT_EQ(findOption("no-such-option"), nullptr);
}

TEST(RegistrationOptions, SwitchesAndChoicesAreKnownByNameAndByNumber)
{
    const OptionField& resample = *findOption("resample");
    EXPECT_EQ(valueFrom(resample, "on"), OptionValue(true));
    EXPECT_EQ(valueFrom(resample, 0.0), OptionValue(false));   // as in older case files and scripts
    EXPECT_EQ(valueFrom(resample, 1.0), OptionValue(true));
    EXPECT_FALSE(valueFrom(resample, 0.5) || valueFrom(resample, 2.0) || valueFrom(resample, "yes"));
    EXPECT_EQ(nameOf(resample, true), "on");

    const OptionField& preset = *findOption("preset");
    EXPECT_EQ(valueFrom(preset, "seed_metric"), OptionValue(std::size_t{2}));
    EXPECT_EQ(valueFrom(preset, 2.0), OptionValue(std::size_t{2}));
    EXPECT_FALSE(valueFrom(preset, 4.0) || valueFrom(preset, "on"));
    RegistrationOptions options;
    preset.write(options, *valueFrom(preset, "seed_metric"));
    EXPECT_EQ(options.seed.preset, PriorPreset::SeedMetric);
}

TEST(RegistrationOptions, ATextThatIsNoValueSaysWhatWouldBe)
{
    RegistrationOptions options;
    EXPECT_EQ("options.needs-whole-number", setOption(options, "maxIterations=40.5").error().message.id());
    EXPECT_EQ("Option 'search' must be one of off, on, not 'perhaps'.",
              setOption(options, "search=perhaps").error().message.text());
    EXPECT_EQ("options.needs-value", setOption(options, "maxIterations=many").error().message.id());
    EXPECT_TRUE(setOption(options, "finalScalePx=1.25"));
    EXPECT_EQ(1.25, options.finalScalePx);
}

TEST(RegistrationOptions, NamesTheFieldThatIsOutOfRange)
{
    for (const OptionField& field : optionFields()) {
        RegistrationOptions options;
        if (std::holds_alternative<SwitchOption>(field.type)) {
            continue;   // a switch has no value out of range
        }
        const double beyond = rangeOf(field).max + 1.0;
        field.write(options, namesOf(field).empty() ? OptionValue(beyond) : static_cast<std::size_t>(beyond));
        ASSERT_TRUE(findProblem(options)) << field.key;
        EXPECT_NE(findProblem(options)->text().find(field.key), std::string::npos) << field.key;
    }
    RegistrationOptions options;
    options.finalScalePx = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(findProblem(options)->text(), "Option finalScalePx is out of range. Enter a number from 0.1 to 20.");
}

}   // namespace
}   // namespace angiopose::core
