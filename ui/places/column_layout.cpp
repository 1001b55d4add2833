#include "ui/places/column_layout.h"

#include <QDataStream>
#include <QIODevice>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr qint32 layoutVersion = 1;

int shareOf(int width, double share, int least, int most)
{
    return std::clamp(static_cast<int>(share * width), least, most);
}

}   // namespace

ColumnLayout columnsFor(Work work, int windowWidth)
{
    ColumnLayout columns;
    switch (work) {
        case Work::Tracing:   // slices and 3-D view
            columns.leftWidth = shareOf(windowWidth, 0.34, 300, 760);
            columns.cornerShare = 0.68;
            columns.isRightFolded = true;
            break;
        case Work::Registering:
            break;
        case Work::Reviewing:   // image and result
            columns.rightWidth = shareOf(windowWidth, 0.28, 320, 480);
            columns.isLeftFolded = true;
            break;
    }
    return columns;
}

QByteArray bytesOf(const WorkLayout& layout)
{
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    const ColumnLayout& columns = layout.columns;
    stream << layoutVersion << qint32{columns.leftWidth} << qint32{columns.rightWidth} << columns.isLeftFolded
           << columns.isRightFolded << columns.cornerShare << layout.areSlicesLarge << qint32{layout.cornerPlane};
    return bytes;
}

std::optional<WorkLayout> workLayoutOf(const QByteArray& bytes)
{
    QDataStream stream(bytes);
    qint32 version = 0;
    qint32 left = 0;
    qint32 right = 0;
    qint32 plane = 0;
    WorkLayout layout;
    stream >> version >> left >> right >> layout.columns.isLeftFolded >> layout.columns.isRightFolded >>
        layout.columns.cornerShare >> layout.areSlicesLarge >> plane;
    const bool isSound = stream.status() == QDataStream::Ok && version == layoutVersion && left > 0 && right > 0 &&
                         plane >= 0 && plane <= 3 && layout.columns.cornerShare > 0.0 &&
                         layout.columns.cornerShare < 1.0;
    if (!isSound) {
        return std::nullopt;
    }
    layout.columns.leftWidth = left;
    layout.columns.rightWidth = right;
    layout.cornerPlane = plane;
    return layout;
}

}   // namespace angiopose::ui
