#include "ui/scenes/label_places.h"

#include <gtest/gtest.h>

namespace angiopose::ui {
namespace {

ViewRect boxOf(const Eigen::Vector2d& corner, const LabelRequest& label)
{
    return {corner.x(), corner.x() + label.size.x(), corner.y(), corner.y() + label.size.y()};
}

bool overlaps(const ViewRect& a, const ViewRect& b)
{
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

}   // namespace

TEST(LabelPlaces, LabelsOfNeighborsDoNotCoverEachOther)
{
    std::vector<LabelRequest> labels;
    for (int i = 0; i < 5; ++i) {
        labels.push_back({{200.0 + 6.0 * i, 150.0 + 3.0 * i}, {90.0, 16.0}});
    }
    const auto corners = placeLabels(labels, {500.0, 400.0, {}, {}});
    for (std::size_t i = 0; i < labels.size(); ++i) {
        for (std::size_t j = i + 1; j < labels.size(); ++j) {
            EXPECT_FALSE(overlaps(boxOf(corners[i], labels[i]), boxOf(corners[j], labels[j]))) << i << " " << j;
        }
    }
}

TEST(LabelPlaces, LabelsStayInsideAndOffTexts)
{
    const LabelRequest label{{495.0, 395.0}, {90.0, 16.0}};
    const ViewRect text{380.0, 500.0, 360.0, 400.0};
    const ViewRect box = boxOf(placeLabels({label}, {500.0, 400.0, {text}, {}})[0], label);
    EXPECT_GE(box.left, 0.0);
    EXPECT_LE(box.right, 500.0);
    EXPECT_LE(box.bottom, 400.0);
    EXPECT_FALSE(overlaps(box, text));
}

TEST(LabelPlaces, LabelsKeepClearOfVessels)
{
    LabelObstacles ground{500.0, 400.0, {}, {}};
    for (int i = 0; i < 200; ++i) {
        ground.avoided.emplace_back(200.0 + i,
                                    150.0 + 0.2 * i);   // to the lower right, the preferred position of labels
    }
    const LabelRequest label{{200.0, 150.0}, {90.0, 16.0}};
    const ViewRect box = boxOf(placeLabels({label}, ground)[0], label);
    for (const Eigen::Vector2d& point : ground.avoided) {
        EXPECT_FALSE(point.x() > box.left && point.x() < box.right && point.y() > box.top && point.y() < box.bottom);
    }
}

}   // namespace angiopose::ui
