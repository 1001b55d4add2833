#pragma once

#include <string>
#include <vector>

namespace benchmarks {

/// A table for the terminal: first column flush left, numbers flush right, a rule below the head.
class TextTable {
public:
    explicit TextTable(std::vector<std::string> head) : head_(std::move(head)) {}

    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
    std::string toText() const;

private:
    std::vector<std::string> head_;
    std::vector<std::vector<std::string>> rows_;
};

/// `value` with so many decimals; "-" when it is not a number.
std::string fixed(double value, int decimals);

/// `value` with three significant digits, as a power of ten when it is tiny.
std::string significant(double value);

}   // namespace benchmarks
