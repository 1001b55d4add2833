#pragma once

#include "ui/places/folding_column.h"

#include <QByteArray>

#include <optional>

namespace angiopose::ui {

inline constexpr int columnBorderWidth = 9;   ///< with the button that folds the column

/// Widths and folding of the columns beside the image, and how much of the left one's height the 3-D view has.
struct ColumnLayout {
    int leftWidth = 300;
    int rightWidth = 320;
    bool isLeftFolded = false;
    bool isRightFolded = false;
    double cornerShare = 0.42;

    bool operator==(const ColumnLayout&) const = default;
};

/// What the window is used for in a step: a scan is traced, vessels are registered, or a result is looked at.
enum class Work { Tracing, Registering, Reviewing };

/// Which columns a work needs, in a window of this width.
ColumnLayout columnsFor(Work work, int windowWidth);

/// How the window stands in one work.
struct WorkLayout {
    ColumnLayout columns;
    bool areSlicesLarge = false;
    int cornerPlane = 0;   ///< 0: 3-D, then `core::bodyPlanes`

    bool operator==(const WorkLayout&) const = default;
};

/// As stored, and from there; none from bytes that are no layout.
QByteArray bytesOf(const WorkLayout& layout);
std::optional<WorkLayout> workLayoutOf(const QByteArray& bytes);

}   // namespace angiopose::ui
