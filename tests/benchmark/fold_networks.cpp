#include "tests/benchmark/fold_networks.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>

namespace angiopose::benchmarks {
namespace {

std::optional<core::VesselNetwork> networkFrom(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
    return core::VesselNetwork::read(bytes);
}

}   // namespace

std::optional<FoldNetworks> FoldNetworks::read(const std::filesystem::path& folder)
{
    FoldNetworks folds;
    std::ifstream list(folder / "folds.txt");
    for (std::string line; std::getline(list, line);) {
        std::istringstream words(line);
        std::string name;
        words >> name;
        auto network = networkFrom(folder / name);
        if (!network) {
            std::fprintf(stderr, "%s is no network.\n", (folder / name).c_str());
            return std::nullopt;
        }
        folds.networks_.emplace(name, std::move(*network));
        for (int image = 0; words >> image;) {
            folds.networkOfImage_[image] = name;
        }
    }
    if (folds.networks_.empty()) {
        std::fprintf(stderr, "%s names no networks.\n", (folder / "folds.txt").c_str());
        return std::nullopt;
    }
    return folds;
}

std::vector<int> FoldNetworks::images() const
{
    std::vector<int> images;
    for (const auto& [image, name] : networkOfImage_) {
        images.push_back(image);
    }
    return images;
}

const core::VesselNetwork* FoldNetworks::unbiasedFor(int image) const
{
    const auto name = networkOfImage_.find(image);
    return name == networkOfImage_.end() ? nullptr : &networks_.at(name->second);
}

}   // namespace angiopose::benchmarks
