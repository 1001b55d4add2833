#include "tests/benchmark/arguments.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace angiopose::benchmarks {

Arguments::Arguments(int argc, char** argv, const std::string& usage) : usage_(usage)
{
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--help" || word == "-h") {
            std::fputs(usage.c_str(), stdout);
            std::exit(0);
        }
        if (!word.starts_with("--")) {
            positional_.push_back(word);
            continue;
        }
        const std::size_t mentioned = usage.find(word + " ");
        if (mentioned == std::string::npos) {
            fail("unknown option " + word);
        }
        const bool takesValue = usage.compare(mentioned + word.size() + 1, 1, "<") == 0;
        if (takesValue && i + 1 >= argc) {
            fail(word + " needs a value");
        }
        values_[word.substr(2)] = takesValue ? argv[++i] : "on";
    }
}

double Arguments::number(const std::string& name, double fallback) const
{
    const auto found = values_.find(name);
    if (found == values_.end()) {
        return fallback;
    }
    char* end = nullptr;
    const double value = std::strtod(found->second.c_str(), &end);
    if (end == found->second.c_str() || *end != '\0') {
        fail("--" + name + " needs a number, not \"" + found->second + "\"");
    }
    return value;
}

std::string Arguments::text(const std::string& name, const std::string& fallback) const
{
    const auto found = values_.find(name);
    return found == values_.end() ? fallback : found->second;
}

std::vector<std::string> Arguments::list(const std::string& name, const std::string& fallback) const
{
    std::istringstream words(text(name, fallback));
    std::vector<std::string> result;
    for (std::string word; std::getline(words, word, ',');) {
        result.push_back(word);
    }
    return result;
}

bool Arguments::isSet(const std::string& name) const
{
    return values_.contains(name);
}

void Arguments::fail(const std::string& problem) const
{
    std::fprintf(stderr, "%s\n\n%s", problem.c_str(), usage_.c_str());
    std::exit(2);
}

}   // namespace angiopose::benchmarks
