#include "core/evaluation/trial/evaluated_method.h"
#include "core/registration/methods/method_info.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <set>

using namespace angiopose;

namespace {

using namespace core;

TEST(EvaluatedMethod, ReadsSettingsByNameAndByChoice)
{
    const auto evaluatedMethod = parseMethod("dynaweight:seed_noprior:rotationFirst=off:maxIterations=30");
    ASSERT_TRUE(evaluatedMethod) << evaluatedMethod.error().message;
    const RegistrationOptions& options = evaluatedMethod.value().options;
    EXPECT_EQ(options.method, "dynaweight");
    EXPECT_EQ(options.seed.preset, PriorPreset::NoPrior);
    EXPECT_FALSE(options.seed.rotationFirst);
    EXPECT_EQ(options.maxIterations, 30);
    EXPECT_EQ(evaluatedMethod.value().label, "dynaweight:seed_noprior:rotationFirst=off:maxIterations=30");
}

TEST(EvaluatedMethod, NamesWhatIsUnknown)
{
    for (const auto& [request, named] : {std::pair<std::string, std::string>{"magic", "magic"},
                                         {"dynaweight:seed_magic", "seed_magic"},
                                         {"angiopose:seed_mean", "seed_mean"},   // not an option of this method
                                         {"dynaweight:off", "'off'"},   // the error must name the value of a switch
                                         {"dynaweight:magic=1", "magic"},
                                         {"dynaweight:maxIterations=0", "maxIterations"},
                                         {"", "''"}}) {
        const auto evaluatedMethod = parseMethod(request);
        ASSERT_FALSE(evaluatedMethod) << request;
        EXPECT_NE(evaluatedMethod.error().message.text().find(named), std::string::npos)
            << evaluatedMethod.error().message;
    }
    EXPECT_FALSE(parseMethods(""));
    EXPECT_FALSE(parseMethods("angiopose,magic"));
}

TEST(EvaluatedMethod, GroupsStandForTheirMembers)
{
    const auto all = parseMethods("all,angiopose");
    ASSERT_TRUE(all);
    // Excludes the method for guidewires, adds dynaweight without its prior, and includes the repeated method once.
    EXPECT_EQ(all.value().size(), methodInfos().size());
    EXPECT_FALSE(
        std::ranges::any_of(all.value(), [](const EvaluatedMethod& one) { return one.options.method == "wire"; }));
    const auto ablation = parseMethods("ablation");
    ASSERT_TRUE(ablation) << ablation.error().message;
    std::set<std::tuple<PriorPreset, bool, bool>> settings;
    for (const EvaluatedMethod& evaluatedMethod : ablation.value()) {
        settings.insert({evaluatedMethod.options.seed.preset, evaluatedMethod.options.seed.rotationFirst,
                         evaluatedMethod.options.seed.alternation});
    }
    EXPECT_EQ(settings.size(), 16u);
}

TEST(EvaluatedMethod, PublishedSolversTakeExactTargetsAsTheyAre)
{
    EXPECT_EQ(optionsFor(parseMethod("dynaweight").value(), true).resample, 0.0);
    EXPECT_EQ(optionsFor(parseMethod("dynaweight").value(), false).resample, 1.0);
    EXPECT_EQ(optionsFor(parseMethod("dynaweight:resample=on").value(), true).resample, 1.0);
    EXPECT_EQ(optionsFor(parseMethod("angiopose").value(), true).resample, 1.0);
}

}   // namespace
