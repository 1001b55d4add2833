#pragma once

#include <map>
#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// Command line of a table program: `--name value` pairs, `--name` alone for switches, everything else is positional.
class Arguments {
public:
    /// Prints `usage` and exits for --help (0) or for an option that it does not mention (2).
    Arguments(int argc, char** argv, const std::string& usage);

    double number(const std::string& name, double fallback) const;
    std::string text(const std::string& name, const std::string& fallback) const;
    std::vector<std::string> list(const std::string& name, const std::string& fallback) const;   ///< comma-separated
    bool isSet(const std::string& name) const;
    const std::vector<std::string>& positional() const { return positional_; }

private:
    [[noreturn]] void fail(const std::string& problem) const;

    std::string usage_;
    std::map<std::string, std::string> values_;
    std::vector<std::string> positional_;
};

}   // namespace angiopose::benchmarks
