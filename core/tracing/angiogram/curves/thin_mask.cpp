#include "core/tracing/angiogram/curves/thin_mask.h"

#include "core/support/cell_index.h"

#include <algorithm>
#include <array>
#include <bit>

namespace angiopose::core {
namespace {

/// Computes for each 3×3 neighborhood (bit k: neighbor k is set, counterclockwise from east) whether the center pixel
/// can be deleted.
std::array<bool, 256> makeDeletableTable()
{
    std::array<bool, 256> table{};
    for (unsigned bits = 0; bits < 256; ++bits) {
        const auto clear = [bits](unsigned k) { return (bits >> (k % 8) & 1U) == 0U ? 1 : 0; };
        int crossings = 0;   // Yokoi's crossing number for 8-connected objects
        for (unsigned k = 0; k < 8; k += 2) {
            crossings += clear(k) - clear(k) * clear(k + 1) * clear(k + 2);
        }
        table[bits] = crossings == 1 && std::popcount(bits) >= 2;
    }
    return table;
}

/// Thins a mask padded with a clear border, so that every pixel has eight neighbors.
class PixelThinner {
public:
    explicit PixelThinner(const Mask2d& mask)
        : mask_(mask),
          stride_(mask.width + 2),
          isSet_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(mask.height + 2)),
          queued_(isSet_.size()),
          neighbors_{1, 1 - stride_, -stride_, -1 - stride_, -1, stride_ - 1, stride_, stride_ + 1}
    {
        for (int y = 0; y < mask.height; ++y) {
            for (int x = 0; x < mask.width; ++x) {
                isSet_[paddedIndex(x, y)] = mask.at(x, y) != 0;
            }
        }
    }

    Mask2d run()
    {
        std::vector<std::size_t> border = borderPixels();
        while (!border.empty()) {
            std::vector<std::size_t> next;
            for (const std::size_t side : {2, 6, 4, 0}) {   // north, south, west, east
                thinFromSide(border, side, next);
            }
            for (const std::size_t p : next) {
                queued_[p] = 0;
            }
            border = std::move(next);
        }
        return result();
    }

private:
    std::size_t paddedIndex(int x, int y) const { return cellIndex(y + 1, stride_, x + 1); }
    std::size_t neighbor(std::size_t p, std::size_t k) const { return p + static_cast<std::size_t>(neighbors_[k]); }

    bool isDeletable(std::size_t p) const
    {
        static const std::array<bool, 256> table = makeDeletableTable();
        unsigned bits = 0;
        for (std::size_t k = 0; k < 8; ++k) {
            bits |= static_cast<unsigned>(isSet_[neighbor(p, k)]) << k;
        }
        return table[bits];
    }

    std::vector<std::size_t> borderPixels() const
    {
        std::vector<std::size_t> border;
        for (std::size_t p = 0; p < isSet_.size(); ++p) {
            if (isSet_[p] != 0 &&
                (isSet_[p + 1] & isSet_[p - 1] & isSet_[neighbor(p, 2)] & isSet_[neighbor(p, 6)]) == 0) {
                border.push_back(p);
            }
        }
        return border;
    }

    /// Deletes pixels that are open to one side. All candidates are collected first, then each is checked again,
    /// because two neighbors that are each deletable alone must not be deleted together.
    void thinFromSide(const std::vector<std::size_t>& border, std::size_t side, std::vector<std::size_t>& next)
    {
        std::vector<std::size_t> candidates;
        for (const std::size_t p : border) {
            if (isSet_[p] != 0 && isSet_[neighbor(p, side)] == 0 && isDeletable(p)) {
                candidates.push_back(p);
            }
        }
        for (const std::size_t p : candidates) {
            if (!isDeletable(p)) {
                continue;
            }
            isSet_[p] = 0;
            for (std::size_t k = 0; k < 8; ++k) {
                const std::size_t q = neighbor(p, k);
                if (isSet_[q] != 0 && queued_[q] == 0) {
                    queued_[q] = 1;
                    next.push_back(q);
                }
            }
        }
    }

    Mask2d result() const
    {
        Mask2d skeleton(mask_.width, mask_.height);
        for (int y = 0; y < mask_.height; ++y) {
            for (int x = 0; x < mask_.width; ++x) {
                skeleton.at(x, y) = isSet_[paddedIndex(x, y)] != 0 ? 255 : 0;
            }
        }
        return skeleton;
    }

    const Mask2d& mask_;
    int stride_;
    std::vector<std::uint8_t> isSet_;
    std::vector<std::uint8_t> queued_;
    std::array<int, 8> neighbors_;
};

}   // namespace

Mask2d skeletonize(const Mask2d& mask)
{
    return mask.isEmpty() ? mask : PixelThinner(mask).run();
}

}   // namespace angiopose::core
