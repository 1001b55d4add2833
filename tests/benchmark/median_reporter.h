#pragma once

#include <benchmark/benchmark.h>
#include <map>
#include <string>

namespace angiopose::benchmarks {

/// Console output that also stores each benchmark's median processor time, the figure least affected by other programs.
class MedianReporter : public benchmark::ConsoleReporter {
public:
    MedianReporter() : ConsoleReporter(OO_Tabular) {}

    void ReportRuns(const std::vector<Run>& reports) override
    {
        for (const Run& run : reports) {
            if (run.aggregate_name == "median") {
                mediansMs_[run.run_name.function_name] = run.GetAdjustedCPUTime();
            }
        }
        ConsoleReporter::ReportRuns(reports);
    }

    /// Median in ms; 0 if the benchmark did not run.
    double medianMs(const std::string& name) const
    {
        const auto found = mediansMs_.find(name);
        return found == mediansMs_.end() ? 0.0 : found->second;
    }

private:
    std::map<std::string, double> mediansMs_;
};

}   // namespace angiopose::benchmarks
