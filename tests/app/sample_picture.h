#pragma once

#include "app/files/sample_case.h"
#include "app/texts/overlay_image.h"
#include "io/case/case_file.h"

#include <gtest/gtest.h>

namespace angiopose::test {

/// Fixture with the sample case as read from its file, and export options for its images.
class SamplePicture : public ::testing::Test {
protected:
    explicit SamplePicture(int widthPx)
    {
        options.widthPx = widthPx;
        options.coloring = app::OverlayColoring::Branches;
    }
    void SetUp() override
    {
        const auto path = app::writeSampleCase();
        ASSERT_TRUE(path) << path.error().message;
        core::Messages warnings;
        auto loaded = io::loadCase(path.value().toStdString(), warnings);
        ASSERT_TRUE(loaded) << loaded.error().message;
        sample = std::move(loaded).value();
    }

    core::Case sample;
    app::OverlayImageOptions options;
};

}   // namespace angiopose::test
