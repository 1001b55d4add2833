#include "ui/panels/result_sentences.h"
#include "core/messages/messages.h"
#include "core/registration/deformable/deform_vessels.h"

#include <gtest/gtest.h>

namespace angiopose::ui {
namespace {

core::VesselTree treeOf(const std::vector<std::string>& names)
{
    core::VesselTree tree;
    for (const std::string& name : names) {
        tree.branches.push_back({static_cast<int>(tree.branches.size()) + 1, name, {{0, 0, 0}, {10, 0, 0}}, {}});
    }
    return tree;
}

core::RegistrationResult resultWith(const std::vector<double>& medianPx)
{
    core::RegistrationResult result;
    for (const double median : medianPx) {
        result.branches.push_back({static_cast<int>(result.branches.size()) + 1, 10, median, 2.0 * median, 1.0});
    }
    result.uncertainty.observed.fill(true);
    result.uncertainty.inPlaneMm = 0.1;
    result.uncertainty.rotationDeg = {0.3, 0.2, 0.1};
    result.uncertainty.depthMm = 4.0;
    result.trustworthy = true;
    return result;
}

TEST(ResultSentences, SayWhatIsCertainAndWhatOneViewCannotTell)
{
    const auto sentences = sentencesOf(resultWith({1.0, 1.0}), treeOf({"LM", ""}), 0.3);

    ASSERT_EQ(sentences.certain.size(), 1);
    EXPECT_EQ(sentences.certain.front(),
              QStringLiteral("In plane ±0.1 mm, rotation ±0.3°. 2 of 2 branches agree within 0.5 mm."));
    ASSERT_EQ(sentences.doubtful.size(), 1);
    EXPECT_EQ(sentences.doubtful.front(), QStringLiteral("Depth is the least certain: ±4.0 mm."));
}

TEST(ResultSentences, NameTheBranchThatDisagrees)
{
    const auto sentences = sentencesOf(resultWith({1.0, 10.0}), treeOf({"LM", ""}), 0.3);

    EXPECT_TRUE(sentences.doubtful.join(' ').contains(QStringLiteral("Branch 2 is 3.0 mm off")));
}

TEST(ResultSentences, DoNotRepeatThatABranchIsEmpty)
{
    core::RegistrationResult result = resultWith({1.0, 10.0});
    result.unopacified = {{2, 0.9}};
    const auto sentences = sentencesOf(result, treeOf({"LM", ""}), 0.3);
    EXPECT_FALSE(sentences.doubtful.join(' ').contains(QStringLiteral("Branch 2"))) << "the run's warning names it";
}

TEST(ResultSentences, DoNotCallABranchEmptyThatABendExplains)
{
    for (const core::DeformationVerdict verdict :
         {core::DeformationVerdict::Deformed, core::DeformationVerdict::Unsure}) {
        core::RegistrationResult result = resultWith({10.0, 10.0});
        core::DeformableResult deformed;
        deformed.verdict = verdict;
        deformed.branches = {{1, {}, {}, 0.9}, {2, {}, {}, 0.1}};
        result.deformed = std::make_shared<const core::DeformableResult>(deformed);
        const QString said = sentencesOf(result, treeOf({"LM", ""}), 0.3).doubtful.join(' ');
        EXPECT_TRUE(said.contains(QStringLiteral("Branch 2"))) << "it was not seen where the bend has it";
        EXPECT_EQ(said.contains(QStringLiteral("LM")), verdict != core::DeformationVerdict::Deformed)
            << said.toStdString();
    }
}

TEST(ResultSentences, HaveNothingCertainWhenTheFitIsNotTrustworthy)
{
    core::RegistrationResult result = resultWith({20.0, 20.0});
    result.trustworthy = false;
    result.warnings = {core::messages::alternativePoseFits()};

    const auto sentences = sentencesOf(result, treeOf({"LM", "LAD"}), 0.3);

    EXPECT_TRUE(sentences.certain.isEmpty());
    EXPECT_TRUE(sentences.doubtful.contains(
        QStringLiteral("Another pose fits the image almost as well: compare the other solutions.")));
}

TEST(ResultSentences, SayHowLikelyTheOverlayIsRightWhereThatIsKnown)
{
    core::RegistrationResult result = resultWith({1.0, 1.0});
    EXPECT_FALSE(
        sentencesOf(result, treeOf({"LM", "LAD"}), 0.3).certain.join(' ').contains(QStringLiteral("probability")));
    result.probabilityWithin2Mm = 0.9987;   // probabilities were only calibrated up to 99 %
    EXPECT_TRUE(
        sentencesOf(result, treeOf({"LM", "LAD"}), 0.3)
            .certain.join(' ')
            .contains(QStringLiteral("The overlay is within 2 mm of the vessels with a probability of 99\u00a0%.")));
    result.trustworthy = false;
    result.probabilityWithin2Mm = 0.314;
    EXPECT_TRUE(
        sentencesOf(result, treeOf({"LM", "LAD"}), 0.3).doubtful.join(' ').contains(QStringLiteral("31\u00a0%")));
}

}   // namespace
}   // namespace angiopose::ui
