#include "tests/benchmark/artery_graph.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace angiopose::benchmarks {
namespace {

std::vector<ArteryGraph::Row> numbersIn(const std::filesystem::path& file)
{
    std::ifstream stream(file);
    std::vector<ArteryGraph::Row> rows;
    std::string line;
    std::getline(stream, line);   // column names
    while (std::getline(stream, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream cells(line);
        ArteryGraph::Row row;
        for (double value = 0.0; cells >> value;) {
            row.push_back(value);
        }
        rows.push_back(row);
    }
    return rows;
}

}   // namespace

ArteryGraph readArteryGraph(const std::string& folder, int patient)
{
    const std::string name = "Anzhen00" + std::to_string(patient);
    const std::filesystem::path stem = std::filesystem::path(folder) / "csv" / name;
    return {name, numbersIn(stem.string() + "_nodes.csv"), numbersIn(stem.string() + "_edges.csv")};
}

}   // namespace angiopose::benchmarks
