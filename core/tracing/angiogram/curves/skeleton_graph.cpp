#include "core/tracing/angiogram/curves/skeleton_graph.h"

#include "core/imaging/mask_morphology.h"

#include <array>

namespace angiopose::core {
namespace {

/// Follows the skeleton pixel by pixel; `nodeAt_` holds the node of junction and end pixels, -1 elsewhere.
class PixelGraphBuilder {
public:
    explicit PixelGraphBuilder(const Mask2d& skeleton)
        : skeleton_(skeleton), nodeAt_(skeleton.width, skeleton.height, -1), visited_(skeleton.width, skeleton.height)
    {
        for (std::size_t p = 0; p < skeleton.pixels.size(); ++p) {
            if (skeleton.pixels[p] != 0) {
                skeletonPixels_.push_back(p);
            }
        }
    }

    SkeletonGraph run()
    {
        addJunctions();
        addEnds();
        for (const std::size_t p : skeletonPixels_) {
            if (nodeAt_.pixels[p] >= 0) {
                addEdgesFrom(p);
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
        std::vector<std::size_t> adjacentPixels;
        for (const auto& [dx, dy] : steps) {
            if (skeleton_.contains(x + dx, y + dy) && skeleton_.at(x + dx, y + dy) != 0) {
                adjacentPixels.push_back(skeleton_.index(x + dx, y + dy));
            }
        }
        return adjacentPixels;
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
            visited_.pixels[p] = 255;
        }
        graph_.nodesPx.emplace_back(sum / static_cast<double>(pixels.size()));
        return node;
    }

    void addJunctions()
    {
        Mask2d junctions(skeleton_.width, skeleton_.height);
        for (const std::size_t p : skeletonPixels_) {
            junctions.pixels[p] = neighborsOf(p).size() > 2 ? 255 : 0;
        }
        for (const std::vector<std::size_t>& pixels : componentsOf(junctions)) {
            addNode(pixels);
        }
    }

    void addEnds()
    {
        for (const std::size_t p : skeletonPixels_) {
            if (nodeAt_.pixels[p] < 0 && neighborsOf(p).size() == 1) {
                addNode({p});
            }
        }
    }

    void addEdgesFrom(std::size_t nodePixel)
    {
        for (const std::size_t first : neighborsOf(nodePixel)) {
            const int start = nodeAt_.pixels[nodePixel];
            const int neighborNode = nodeAt_.pixels[first];
            if (neighborNode > start) {   // adjacent nodes; the edge is added once
                graph_.edges.push_back({start,
                                        neighborNode,
                                        {graph_.nodesPx[static_cast<std::size_t>(start)],
                                         graph_.nodesPx[static_cast<std::size_t>(neighborNode)]}});
            } else if (neighborNode < 0 && visited_.pixels[first] == 0) {
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
            visited_.pixels[current] = 255;
            const std::vector<std::size_t> neighbors = neighborsOf(current);
            const std::size_t next = neighbors[0] == previous ? neighbors[1] : neighbors[0];
            previous = current;
            current = next;
        }
        const int end = nodeAt_.pixels[current];
        points.push_back(graph_.nodesPx[static_cast<std::size_t>(end)]);
        const bool isTinyLoop = start == end && points.size() < minRingPoints;
        if (!isTinyLoop) {
            graph_.edges.push_back({start, end, std::move(points)});
        }
    }

    void addRings()
    {
        for (const std::size_t p : skeletonPixels_) {
            if (visited_.pixels[p] == 0) {
                const std::vector<std::size_t> neighbors = neighborsOf(p);
                if (neighbors.size() == 2) {
                    addNode({p});
                    addEdge(p, neighbors[0]);
                }
            }
        }
    }

    struct Step {
        int dx;
        int dy;
    };
    static constexpr std::array<Step, 8> steps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
    static constexpr std::size_t minRingPoints = 6;

    const Mask2d& skeleton_;
    Image2d<int> nodeAt_;
    Mask2d visited_;
    std::vector<std::size_t> skeletonPixels_;   ///< skeleton pixels, row by row
    SkeletonGraph graph_;
};

}   // namespace

SkeletonGraph buildSkeletonGraph(const Mask2d& skeleton)
{
    return PixelGraphBuilder(skeleton).run();
}

}   // namespace angiopose::core
