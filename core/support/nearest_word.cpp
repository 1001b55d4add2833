#include "core/support/nearest_word.h"

#include <Eigen/Core>
#include <algorithm>

namespace angiopose::core {
namespace {

int editDistance(const std::string& a, const std::string& b)
{
    const auto rows = static_cast<Eigen::Index>(a.size());
    const auto columns = static_cast<Eigen::Index>(b.size());
    Eigen::ArrayXXi cost(rows + 1, columns + 1);
    for (Eigen::Index i = 0; i <= rows; ++i) {
        for (Eigen::Index j = 0; j <= columns; ++j) {
            if (i == 0 || j == 0) {
                cost(i, j) = static_cast<int>(i + j);
                continue;
            }
            const auto at = [](const std::string& text, Eigen::Index k) { return text[static_cast<std::size_t>(k)]; };
            const int change = at(a, i - 1) == at(b, j - 1) ? 0 : 1;
            cost(i, j) = std::min({cost(i - 1, j) + 1, cost(i, j - 1) + 1, cost(i - 1, j - 1) + change});
            if (i > 1 && j > 1 && at(a, i - 1) == at(b, j - 2) && at(a, i - 2) == at(b, j - 1)) {
                cost(i, j) = std::min(cost(i, j), cost(i - 2, j - 2) + 1);
            }
        }
    }
    return cost(rows, columns);
}

}   // namespace

std::string nearestWord(const std::string& word, const std::vector<std::string>& words)
{
    std::string nearest;
    int minDistance = static_cast<int>(word.size()) / 3 + 1;
    for (const std::string& each : words) {
        if (const int distance = editDistance(word, each); distance < minDistance) {
            minDistance = distance;
            nearest = each;
        }
    }
    return nearest;
}

}   // namespace angiopose::core
