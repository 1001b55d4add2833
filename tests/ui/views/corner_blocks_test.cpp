#include "ui/views/corner_blocks.h"

#include "ui/views/shadowed_text.h"

#include <gtest/gtest.h>
#include <QImage>
#include <QPainter>

namespace angiopose::ui {
namespace {

TEST(CornerBlocks, EndInDotsWhereTheImageIsNarrow)
{
    const ImageViewport viewport;
    const OverlayScene scene;
    const std::vector<QRectF> taken;
    const ViewContent ground(viewport, scene, taken);
    const QStringList lines{QStringLiteral("XA"),
                            QStringLiteral("Hospital of a very long name · Left coronary, run 12")};
    for (std::size_t corner = 0; corner < 4; ++corner) {
        QImage picture(180, 400, QImage::Format_RGB32);
        picture.fill(Qt::black);
        QPainter painter(&picture);
        CornerLines own;
        own[corner] = lines;
        const QRectF block = paintCorners(painter, picture.size(), own, ground)[corner];
        painter.end();
        EXPECT_FALSE(block.isEmpty());
        EXPECT_TRUE(QRectF(picture.rect()).adjusted(4.0, 4.0, -4.0, -4.0).contains(block));
        EXPECT_NE(picture, QImage(picture).scaled(1, 1).scaled(picture.size())) << "words are there";
    }
}

TEST(CornerBlocks, AreOfOneSize)
{
    const ImageViewport viewport;
    const OverlayScene scene;
    const QStringList lines{QStringLiteral("XA"), QStringLiteral("Run 12")};
    const auto heightsIn = [&](const std::vector<QRectF>& taken) {
        QImage picture(600, 400, QImage::Format_RGB32);
        QPainter painter(&picture);
        std::vector<double> heights;
        for (const QRectF& block :
             paintCorners(painter, picture.size(), {lines, lines, lines, lines}, ViewContent(viewport, scene, taken))) {
            heights.push_back(block.height());
        }
        return heights;
    };
    const std::vector<double> whole = heightsIn({});
    const std::vector<double> crowded = heightsIn({QRectF(12.0, 40.0, 200.0, 20.0)});   // below the first corner block
    ASSERT_GT(whole[0], 0.0);
    EXPECT_EQ(whole, std::vector<double>(4, whole[0]));
    EXPECT_LT(crowded[1], whole[1]);
    EXPECT_EQ(crowded[1], crowded[2]);
    EXPECT_EQ(crowded[2], crowded[3]);
}

}   // namespace
}   // namespace angiopose::ui
