#include "core/evaluation/report/published_results.h"

#include "core/evaluation/trial/run_record.h"

#include <algorithm>
#include <array>

namespace angiopose::core {
namespace {

constexpr double notPublished = unknownMeasure;

template <class Value>
struct ByMethod {
    std::string_view method;
    Value value;
};

template <class Rows>
auto valueOf(const Rows& rows, std::string_view method)
{
    using Value = decltype(rows.begin()->value);
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.method == method; });
    return found == rows.end() ? std::optional<Value>() : std::optional<Value>(found->value);
}

}   // namespace

std::optional<PublishedErrors> publishedSimulation(std::string_view methodId)
{
    static constexpr std::array rows{
        ByMethod<PublishedErrors>{"dynaweight", {1.0, 0.24, 0.34, 0.50, 31.5}},
        ByMethod<PublishedErrors>{"iterative-pnp", {4.0, 0.39, 0.56, 0.84, 16.9}},
        ByMethod<PublishedErrors>{"nicp", {8.0, 0.50, 1.14, 3.11, 385.0}},
        ByMethod<PublishedErrors>{"dt-icp", {54.0, 1.80, 3.49, 6.65, 13.2}},
        ByMethod<PublishedErrors>{"automask", {0.0, 0.85, 1.06, 1.50, 97000.0}},
        ByMethod<PublishedErrors>{"rgbr", {22.0, 2.21, 1.71, 3.92, notPublished}},
    };
    return valueOf(rows, methodId);
}

std::optional<PublishedInVivo> publishedInVivo(std::string_view methodId)
{
    static constexpr std::array rows{
        ByMethod<PublishedInVivo>{"dynaweight", {12.0, 4.02, 11.35, 31.85, 33.2}},
        ByMethod<PublishedInVivo>{"iterative-pnp", {15.0, 6.17, 13.72, 38.89, 16.9}},
        ByMethod<PublishedInVivo>{"nicp", {56.0, 3.49, 10.52, 37.09, 385.1}},
        ByMethod<PublishedInVivo>{"dt-icp", {21.0, 4.84, 14.11, 50.04, 13.2}},
        ByMethod<PublishedInVivo>{"automask", {100.0, 17.01, 23.26, 29.75, 150302.0}},
        ByMethod<PublishedInVivo>{"rgbr", {100.0, 5.99, 12.16, 38.9, notPublished}},
    };
    return valueOf(rows, methodId);
}

std::optional<PublishedRobustness> publishedRobustness(std::string_view conditionId, std::string_view methodId)
{
    struct Row {
        std::string_view condition;
        std::string_view method;
        PublishedRobustness value;
    };
    // The paper prints the same values for the pruned 10 mm block as for another block, so it is omitted (decision 6).
    static constexpr std::array rows{
        Row{"full-5-2", "nicp", {0.578, 0.407, 5.00}},
        Row{"full-5-2", "nicp-alternating", {0.355, 0.203, 3.31}},
        Row{"full-5-2", "iterative-pnp", {0.537, 0.367, 5.00}},
        Row{"full-5-2", "dynaweight", {0.348, 0.202, 3.33}},
        Row{"full-8-3", "nicp", {0.800, 0.632, 8.00}},
        Row{"full-8-3", "nicp-alternating", {0.392, 0.217, 3.82}},
        Row{"full-8-3", "iterative-pnp", {0.753, 0.568, 8.00}},
        Row{"full-8-3", "dynaweight", {0.395, 0.215, 3.86}},
        Row{"full-10-5", "nicp", {1.248, 0.918, 10.0}},
        Row{"full-10-5", "nicp-alternating", {0.420, 0.292, 4.75}},
        Row{"full-10-5", "iterative-pnp", {1.033, 0.738, 10.0}},
        Row{"full-10-5", "dynaweight", {0.410, 0.283, 4.54}},
        Row{"pruned-5-2", "nicp", {0.580, 0.412, 5.00}},
        Row{"pruned-5-2", "nicp-alternating", {0.440, 0.305, 4.68}},
        Row{"pruned-5-2", "iterative-pnp", {0.527, 0.357, 5.00}},
        Row{"pruned-5-2", "dynaweight", {0.428, 0.290, 4.57}},
        Row{"pruned-8-3", "nicp", {0.763, 0.605, 8.00}},
        Row{"pruned-8-3", "nicp-alternating", {0.522, 0.353, 5.41}},
        Row{"pruned-8-3", "iterative-pnp", {0.713, 0.568, 8.00}},
        Row{"pruned-8-3", "dynaweight", {0.513, 0.338, 5.51}},
    };
    for (const Row& row : rows) {
        if (row.condition == conditionId && row.method == methodId) {
            return row.value;
        }
    }
    return std::nullopt;
}

std::optional<PublishedToy> publishedToy(int points, std::string_view methodId)
{
    static constexpr std::array sizes{8, 44, 84, 124, 164};
    using BySize = std::array<PublishedToy, sizes.size()>;
    static constexpr std::array rows{
        ByMethod<BySize>{"dt-icp",
                         {{{0, 0, 0}, {0, 0, 0}, {2.226, .862, .332}, {4.619, .243, .108}, {4.738, .136, .137}}}},
        ByMethod<BySize>{
            "nicp", {{{0, 0, 0}, {.795, .311, .099}, {.742, .292, .099}, {6.650, .214, .100}, {5.193, .147, .100}}}},
        ByMethod<BySize>{
            "iterative-pnp",
            {{{0, 0, 0}, {.018, .012, .003}, {.024, .016, .004}, {3.234, 1.379, .383}, {2.402, .989, .284}}}},
    };
    const auto size = std::find(sizes.begin(), sizes.end(), points);
    const auto values = valueOf(rows, methodId);
    return values && size != sizes.end() ? std::optional((*values)[static_cast<std::size_t>(size - sizes.begin())])
                                         : std::nullopt;
}

}   // namespace angiopose::core
