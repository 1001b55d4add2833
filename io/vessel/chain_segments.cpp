#include "io/vessel/line_set.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

namespace angiopose::io {
namespace {

using Segment = std::pair<std::size_t, std::size_t>;

/// Graph over point indices, built from the segments with the same ID and name.
class SegmentGraph {
public:
    SegmentGraph(const std::set<Segment>& segments, const std::set<std::size_t>& junctions)
        : unused_(segments), junctions_(junctions)
    {
        for (const auto& [from, to] : segments) {
            neighbors_[from].push_back(to);
            neighbors_[to].push_back(from);
        }
    }

    std::vector<std::vector<std::size_t>> chains()
    {
        std::vector<std::vector<std::size_t>> result;
        for (const auto& [point, next] : neighbors_) {
            if (isEnd(point)) {
                for (const std::size_t second : next) {
                    follow(point, second, result);
                }
            }
        }
        while (!unused_.empty()) {   // the remaining segments form closed loops
            const Segment first = *unused_.begin();
            follow(first.first, first.second, result);
        }
        return result;
    }

private:
    bool isEnd(std::size_t point) const { return neighbors_.at(point).size() != 2 || junctions_.contains(point); }

    void follow(std::size_t start, std::size_t second, std::vector<std::vector<std::size_t>>& result)
    {
        std::vector<std::size_t> chain{start};
        for (std::size_t next = second; unused_.erase(std::minmax(chain.back(), next)) > 0;) {
            chain.push_back(next);
            if (isEnd(next) || next == start) {
                break;
            }
            const std::vector<std::size_t>& around = neighbors_[next];
            next = around[0] == chain[chain.size() - 2] ? around[1] : around[0];
        }
        if (chain.size() > 1) {
            result.push_back(std::move(chain));
        }
    }

    std::map<std::size_t, std::vector<std::size_t>> neighbors_;
    std::set<Segment> unused_;
    const std::set<std::size_t>& junctions_;
};

}   // namespace

LineSet chainSegments(const LineSet& set)
{
    const bool onlySegments = set.lines.size() > 1 && std::all_of(set.lines.begin(), set.lines.end(),
                                                                  [](const auto& line) { return line.size() == 2; });
    if (!onlySegments) {
        return set;
    }
    std::map<std::pair<int, std::size_t>, std::set<Segment>> segmentsOf;   // by ID and by the first line with that name
    std::map<std::string_view, std::size_t> firstOfName;
    for (std::size_t i = 0; i < set.lines.size(); ++i) {
        const std::string_view name = set.names.empty() ? std::string_view() : set.names[i];
        const std::size_t first = firstOfName.try_emplace(name, i).first->second;
        if (set.lines[i][0] != set.lines[i][1]) {
            segmentsOf[{set.ids.empty() ? 0 : set.ids[i], first}].insert(std::minmax(set.lines[i][0], set.lines[i][1]));
        }
    }
    LineSet chained = set;
    chained.lines.clear();
    chained.ids.clear();
    chained.names.clear();
    for (const auto& [key, segments] : segmentsOf) {
        for (std::vector<std::size_t>& chain : SegmentGraph(segments, set.junctions).chains()) {
            chained.lines.push_back(std::move(chain));
            if (!set.ids.empty()) {
                chained.ids.push_back(key.first);
            }
            if (!set.names.empty()) {
                chained.names.push_back(set.names[key.second]);
            }
        }
    }
    return chained;
}

}   // namespace angiopose::io
