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
    const Ground ground(viewport, scene, taken);
    const QStringList lines{QStringLiteral("XA"),
                            QStringLiteral("Hospital of a very long name · Left coronary, run 12")};
    for (const Corner corner : {Corner::TopLeft, Corner::TopRight, Corner::BottomLeft, Corner::BottomRight}) {
        QImage picture(180, 400, QImage::Format_RGB32);
        picture.fill(Qt::black);
        QPainter painter(&picture);
        const QRectF block = paintCorner(painter, picture.size(), corner, lines, ground);
        painter.end();
        EXPECT_FALSE(block.isEmpty());
        EXPECT_TRUE(QRectF(picture.rect()).adjusted(4.0, 4.0, -4.0, -4.0).contains(block));
        EXPECT_NE(picture, QImage(picture).scaled(1, 1).scaled(picture.size())) << "words are there";
    }
}

}   // namespace
}   // namespace angiopose::ui
