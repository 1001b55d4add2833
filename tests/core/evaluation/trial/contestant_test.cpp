#include "core/evaluation/trial/contestant.h"
#include "core/registration/methods/method_info.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <set>

using namespace angiopose;

namespace {

using namespace core;

TEST(Contestant, ReadsSettingsByNameAndByChoice)
{
    const auto contestant = contestantFrom("dynaweight:seed_noprior:rotationFirst=off:maxIterations=30");
    ASSERT_TRUE(contestant) << contestant.error().message;
    const RegistrationOptions& options = contestant.value().options;
    EXPECT_EQ(options.method, "dynaweight");
    EXPECT_EQ(options.seed.preset, PriorPreset::NoPrior);
    EXPECT_FALSE(options.seed.rotationFirst);
    EXPECT_EQ(options.maxIterations, 30);
    EXPECT_EQ(contestant.value().label, "dynaweight:seed_noprior:rotationFirst=off:maxIterations=30");
}

TEST(Contestant, NamesWhatIsUnknown)
{
    for (const auto& [request, named] : {std::pair<std::string, std::string>{"magic", "magic"},
                                         {"dynaweight:seed_magic", "seed_magic"},
                                         {"angiopose:seed_mean", "seed_mean"},   // not an option of this method
                                         {"dynaweight:off", "'off'"},   // the error must name the value of a switch
                                         {"dynaweight:magic=1", "magic"},
                                         {"dynaweight:maxIterations=0", "maxIterations"},
                                         {"", "''"}}) {
        const auto contestant = contestantFrom(request);
        ASSERT_FALSE(contestant) << request;
        EXPECT_NE(contestant.error().message.text().find(named), std::string::npos) << contestant.error().message;
    }
    EXPECT_FALSE(contestantsFrom(""));
    EXPECT_FALSE(contestantsFrom("angiopose,magic"));
}

TEST(Contestant, GroupsStandForTheirMembers)
{
    const auto all = contestantsFrom("all,angiopose");
    ASSERT_TRUE(all);
    // Excludes the method for guidewires, adds dynaweight without its prior, and includes the repeated method once.
    EXPECT_EQ(all.value().size(), methodInfos().size());
    EXPECT_FALSE(std::ranges::any_of(all.value(), [](const Contestant& one) { return one.options.method == "wire"; }));
    const auto ablation = contestantsFrom("ablation");
    ASSERT_TRUE(ablation) << ablation.error().message;
    std::set<std::tuple<PriorPreset, bool, bool>> settings;
    for (const Contestant& contestant : ablation.value()) {
        settings.insert({contestant.options.seed.preset, contestant.options.seed.rotationFirst,
                         contestant.options.seed.alternation});
    }
    EXPECT_EQ(settings.size(), 16u);
}

TEST(Contestant, PublishedSolversTakeExactTargetsAsTheyAre)
{
    EXPECT_EQ(optionsFor(contestantFrom("dynaweight").value(), true).resample, 0.0);
    EXPECT_EQ(optionsFor(contestantFrom("dynaweight").value(), false).resample, 1.0);
    EXPECT_EQ(optionsFor(contestantFrom("dynaweight:resample=on").value(), true).resample, 1.0);
    EXPECT_EQ(optionsFor(contestantFrom("angiopose").value(), true).resample, 1.0);
}

}   // namespace
