#include "core/tracing/angiogram/curves/skeleton_graph.h"

#include "core/imaging/mask_morphology.h"

#include <array>

namespace angiopose::core {
namespace {

/// Follows the skeleton pixel by pixel; `nodeAt_` holds the node of junction and end pixels, -1 elsewhere.
class PixelWalker {
public:
    explicit PixelWalker(const Mask2d& skeleton)
        : skeleton_(skeleton), nodeAt_(skeleton.width, skeleton.height, -1), seen_(skeleton.width, skeleton.height)
    {
        for (std::size_t p = 0; p < skeleton.pixels.size(); ++p) {
            if (skeleton.pixels[p] != 0) {
                set_.push_back(p);
            }
        }
    }

    SkeletonGraph run()
    {
        addJunctions();
        addEnds();
        for (const std::size_t p : set_) {
            if (nodeAt_.pixels[p] >= 0) {
                followFrom(p);
            }
        }
        addRings();
        return std::move(graph_);
    }

private:
    std::vector<std::size_t> neighborsOf(std::size_t p) const
    {
        const int x = static_cast<int>(p % static_cast<std::size_t>(skeleton_.width));
        const int y = static_cast<int>(p / static_cast<std::size_t>(skeleton_.width));
        std::vector<std::size_t> found;
        for (const auto& [dx, dy] : steps) {
            if (skeleton_.contains(x + dx, y + dy) && skeleton_.at(x + dx, y + dy) != 0) {
                found.push_back(skeleton_.index(x + dx, y + dy));
            }
        }
        return found;
    }

    Eigen::Vector2d pointOf(std::size_t p) const
    {
        const auto width = static_cast<std::size_t>(skeleton_.width);
        const std::size_t row = p / width;
        return {static_cast<double>(p % width), static_cast<double>(row)};
    }

    int addNode(const std::vector<std::size_t>& pixels)
    {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        const int node = static_cast<int>(graph_.nodesPx.size());
        for (const std::size_t p : pixels) {
            sum += pointOf(p);
            nodeAt_.pixels[p] = node;
            seen_.pixels[p] = 255;
        }
        graph_.nodesPx.emplace_back(sum / static_cast<double>(pixels.size()));
        return node;
    }

    void addJunctions()
    {
        Mask2d junctions(skeleton_.width, skeleton_.height);
        for (const std::size_t p : set_) {
            junctions.pixels[p] = neighborsOf(p).size() > 2 ? 255 : 0;
        }
        for (const std::vector<std::size_t>& pixels : componentsOf(junctions)) {
            addNode(pixels);
        }
    }

    void addEnds()
    {
        for (const std::size_t p : set_) {
            if (nodeAt_.pixels[p] < 0 && neighborsOf(p).size() == 1) {
                addNode({p});
            }
        }
    }

    void followFrom(std::size_t nodePixel)
    {
        for (const std::size_t first : neighborsOf(nodePixel)) {
            const int start = nodeAt_.pixels[nodePixel];
            const int touching = nodeAt_.pixels[first];
            if (touching > start) {   // adjacent nodes; the edge is added once
                graph_.edges.push_back({start,
                                        touching,
                                        {graph_.nodesPx[static_cast<std::size_t>(start)],
                                         graph_.nodesPx[static_cast<std::size_t>(touching)]}});
            } else if (touching < 0 && seen_.pixels[first] == 0) {
                addEdge(nodePixel, first);
            }
        }
    }

    /// Follows the skeleton from a node over `first` to the next node. A path pixel has exactly two neighbors, so the
    /// path is unambiguous.
    void addEdge(std::size_t nodePixel, std::size_t first)
    {
        const int start = nodeAt_.pixels[nodePixel];
        std::vector<Eigen::Vector2d> points{graph_.nodesPx[static_cast<std::size_t>(start)]};
        std::size_t previous = nodePixel;
        std::size_t current = first;
        while (nodeAt_.pixels[current] < 0) {
            points.push_back(pointOf(current));
            seen_.pixels[current] = 255;
            const std::vector<std::size_t> around = neighborsOf(current);
            const std::size_t next = around[0] == previous ? around[1] : around[0];
            previous = current;
            current = next;
        }
        const int end = nodeAt_.pixels[current];
        points.push_back(graph_.nodesPx[static_cast<std::size_t>(end)]);
        const bool isNub = start == end && points.size() < shortestRing;
        if (!isNub) {
            graph_.edges.push_back({start, end, std::move(points)});
        }
    }

    void addRings()
    {
        for (const std::size_t p : set_) {
            if (seen_.pixels[p] == 0) {
                const std::vector<std::size_t> around = neighborsOf(p);
                if (around.size() == 2) {
                    addNode({p});
                    addEdge(p, around[0]);
                }
            }
        }
    }

    struct Step {
        int dx;
        int dy;
    };
    static constexpr std::array<Step, 8> steps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
    static constexpr std::size_t shortestRing = 6;

    const Mask2d& skeleton_;
    Image2d<int> nodeAt_;
    Mask2d seen_;
    std::vector<std::size_t> set_;   ///< skeleton pixels, row by row
    SkeletonGraph graph_;
};

}   // namespace

SkeletonGraph skeletonGraph(const Mask2d& skeleton)
{
    return PixelWalker(skeleton).run();
}

}   // namespace angiopose::core
