#pragma once

#include "tests/cli/run_program.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace angiopose::test {

/// Fixture: a simulated case in a separate folder.
class SimulatedCaseTest : public ::testing::Test {
protected:
    void SetUp() override
    {
        const auto simulated = runCli({"simulate", "--seed", "3", "--output", folder_.file("demo")});
        ASSERT_EQ(simulated.exitCode, 0) << simulated.messages;
        casePath_ = folder_.file("demo/case.angiopose");
    }

    TemporaryFolder folder_;
    std::string casePath_;
};

}   // namespace angiopose::test
