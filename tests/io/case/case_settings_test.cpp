#include "io/case/case_settings.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

std::string refusal(const std::string& assignment)
{
    io::CaseSettings settings;
    const core::Status status = settings.add(assignment);
    return status ? std::string() : status.error().message.text();
}

TEST(CaseSettings, SetOptionsAndTracingByTheNamesOfCaseFiles)
{
    io::CaseSettings settings;
    for (const char* assignment :
         {"PriorWeight=7", "angiogram.trace.sensitivity=1.5", "angiogram.trace.minbranchlengthpx=30",
          "vessel.tracing.threshold=180", "vessel.tracing.tubesOnly=on", "vessel.tracing.loops=kept",
          "vessel.tracing.seedsInPatientMm=[[1,2,3],[4,5,6.5]]", "priorWeight=0.5"}) {
        ASSERT_TRUE(settings.add(assignment)) << assignment;
    }
    core::Case session;
    session.views.emplace_back();
    settings.applyTo(session);
    EXPECT_EQ(session.options.seed.priorWeight, 0.5);
    for (const core::View& view : session.views) {
        EXPECT_EQ(view.traceOptions.sensitivity, 1.5);
        EXPECT_EQ(view.traceOptions.minBranchLengthPx, 30);
    }
    const core::VesselTracingOptions& tracing = session.vessels.input.tracing;
    EXPECT_EQ(tracing.threshold, 180.0);
    EXPECT_TRUE(tracing.tubesOnly);
    EXPECT_EQ(tracing.loops, core::VesselLoops::Kept);
    ASSERT_EQ(tracing.seedsInPatient.size(), 2U);
    EXPECT_EQ(tracing.seedsInPatient[1], Eigen::Vector3d(4.0, 5.0, 6.5));
    EXPECT_EQ(settings.assignments().back(), "vessel.tracing.tubesOnly=on");
    EXPECT_EQ(settings.assignments().size(), 7U);   // a later assignment replaces an earlier one
}

TEST(CaseSettings, EveryNameIsOfOneThingAlone)
{
    std::vector<std::string> names = io::caseSettingNames();
    EXPECT_GT(names.size(), 60U);
    std::ranges::sort(names);
    EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

TEST(CaseSettings, WrongOnesAreToldWithWhatIsNear)
{
    EXPECT_NE(refusal("priorWeigth=1").find("priorWeight"), std::string::npos);
    EXPECT_NE(refusal("pointSpacing=1").find("pointSpacingMm"), std::string::npos);
    EXPECT_NE(refusal("threshold=1").find("vessel.tracing.threshold"), std::string::npos);
    EXPECT_NE(refusal("priorWeight=heavy"), "");
    EXPECT_NE(refusal("priorWeight"), "");
    EXPECT_NE(refusal("angiogram.trace.sensitivity=-1"), "");
    EXPECT_NE(refusal("angiogram.trace.minBranchLengthPx=1.5"), "");
    EXPECT_NE(refusal("vessel.tracing.loops=knotted"), "");
    EXPECT_NE(refusal("vessel.tracing.seedsInPatientMm=[[1,2]]"), "");
    EXPECT_EQ(refusal("vessel.tracing.loops=opened"), "");
}

}   // namespace
