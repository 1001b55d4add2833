#include "app/files/pdf_picture.h"
#include "app/texts/image_file.h"
#include "tests/app/open_window.h"
#include "tests/app/sample_picture.h"
#include "tests/support/temporary_folder.h"

#include <QComboBox>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

#include <Eigen/Eigenvalues>

namespace angiopose::app {
namespace {

constexpr int pictureWidth = 1024;

/// Saturation of each pixel: lines are colored, the image is gray.
core::Image2d<float> colorOf(const QImage& picture)
{
    core::Image2d<float> color(picture.width(), picture.height());
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const QColor pixel = picture.pixelColor(x, y);
            const auto [least, most] = std::minmax({pixel.red(), pixel.green(), pixel.blue()});
            color.at(x, y) = static_cast<float>(most - least);
        }
    }
    return color;
}

/// Shift of `b` against `a` in a tile, px (Lucas and Kanade); undetermined along lines.
Eigen::Vector2d shiftIn(const core::Image2d<float>& a, const core::Image2d<float>& b, int left, int top, int size)
{
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (int y = top + 1; y < top + size - 1; ++y) {
        for (int x = left + 1; x < left + size - 1; ++x) {
            const auto slope = [x, y](const core::Image2d<float>& of) {
                return Eigen::Vector2d(0.5 * (of.at(x + 1, y) - of.at(x - 1, y)),
                                       0.5 * (of.at(x, y + 1) - of.at(x, y - 1)));
            };
            const Eigen::Vector2d gradient = 0.5 * (slope(a) + slope(b));
            normal += gradient * gradient.transpose();
            right += gradient * (a.at(x, y) - b.at(x, y));
        }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(normal);
    Eigen::Vector2d shift = Eigen::Vector2d::Zero();
    for (int axis = 0; axis < 2; ++axis) {
        if (axes.eigenvalues()[axis] > 2e5) {
            shift +=
                axes.eigenvectors().col(axis) * axes.eigenvectors().col(axis).dot(right) / axes.eigenvalues()[axis];
        }
    }
    return shift;
}

QImage rastered(const std::string& svg, int width, int height)
{
    QSvgRenderer renderer(QByteArray::fromStdString(svg));
    EXPECT_TRUE(renderer.isValid());
    QImage picture(width, height, QImage::Format_RGB32);
    picture.fill(Qt::black);
    QPainter painter(&picture);
    renderer.render(&painter, QRectF(0, 0, width, height));
    return picture;
}

class VectorPictures : public test::SamplePicture {
protected:
    VectorPictures() : SamplePicture(pictureWidth) {}
    QImage pixels() const
    {
        const auto drawn = drawOverlay(sample, {}, options);
        EXPECT_TRUE(drawn);
        const core::ColorImage& picture = drawn.value();
        return QImage(picture.rgb.data(), picture.width, picture.height, qsizetype{3} * picture.width,
                      QImage::Format_RGB888)
            .copy();
    }
    ui::VectorImage vectors(const ImageFileOptions& file) const
    {
        auto drawn = imageVectors(sample, {}, options, file);
        EXPECT_TRUE(drawn);
        return std::move(drawn).value();
    }
    std::string svg(const ImageFileOptions& file = {}) const
    {
        return toSvgDocument(vectors(file), svgMetadata(sample, file));
    }

    const test::TemporaryFolder folder;
};

TEST_F(VectorPictures, LinesLieWithinATenthOfAPixelOfThePixels)
{
    constexpr int tile = 64;
    for (const ui::OverlayMode mode : {ui::OverlayMode::Centerline, ui::OverlayMode::Outline}) {
        options.vessels = mode;
        const QImage raster = pixels();
        const QImage vectors = rastered(svg(), raster.width(), raster.height());
        const auto a = colorOf(raster);
        const auto b = colorOf(vectors);
        int seen = 0;
        for (int top = 128; top + tile <= raster.height() - 128; top += tile) {
            for (int left = 128; left + tile <= raster.width() - 128; left += tile) {
                const Eigen::Vector2d shift = shiftIn(a, b, left, top, tile);
                seen += shift.norm() > 0.0 ? 1 : 0;
                EXPECT_LT(shift.norm(), 0.1) << "at " << left << ", " << top;
            }
        }
        EXPECT_GT(seen, 20);
    }
}

TEST_F(VectorPictures, NothingIsDrawnInTheSwipe)
{
    const double column = 0.5 * sample.shown().angiogram->width();
    options.cutout = {ui::Cutout::Shape::RightOf, {column, 0.0}, 0.0};
    const QImage vectors = rastered(svg(), pictureWidth, pictureWidth);
    const auto color = colorOf(vectors);
    int leftOf = 0;
    for (int y = 128; y < vectors.height() - 128; ++y) {
        for (int x = 0; x < pictureWidth / 2 - 8; ++x) {
            leftOf += color.at(x, y) > 60.0F ? 1 : 0;
        }
        for (int x = pictureWidth / 2 + 8; x < pictureWidth; ++x) {
            ASSERT_LT(color.at(x, y), 60.0F) << x << ", " << y;
        }
    }
    EXPECT_GT(leftOf, 200);
}

/// Text without the embedded image, whose Base64 may contain any four letters by chance.
std::string withoutPixels(std::string text)
{
    const std::size_t begin = text.find(";base64,");
    EXPECT_NE(begin, std::string::npos);
    return text.erase(begin, text.find('"', begin) - begin);
}

TEST_F(VectorPictures, SaysWhatPixelsSay)
{
    const std::string text = svg();
    EXPECT_NE(text.find(">Not for clinical use</text>"), std::string::npos);
    EXPECT_NE(text.find("cameraFromPatient: "), std::string::npos);
    EXPECT_NE(text.find(sample.vessels.file.sha256), std::string::npos);
    sample.shown().angiogram = [this] {
        auto run = std::make_shared<core::Angiogram>(*sample.shown().angiogram);
        run->identity.patientName = "Doe^Jane";
        return run;
    }();
    EXPECT_EQ(withoutPixels(svg()).find("Jane"), std::string::npos);
    options.identity = Identity::Shown;
    EXPECT_NE(withoutPixels(svg()).find("Jane"), std::string::npos);
}

TEST_F(VectorPictures, APageHasTheSizeInPrintAndOneImage)
{
    const ImageFileOptions file{ImageFileContent::Overlay, 300.0};
    const QByteArray page = toPdf(vectors(file), svgMetadata(sample, file));
    ASSERT_TRUE(page.startsWith("%PDF"));
    EXPECT_EQ(page.count("/Subtype /Image"), 1);
    EXPECT_GT(page.count("/FontDescriptor"), 0) << "texts are texts";
    const qsizetype at = page.indexOf("/MediaBox [0 0 ");
    ASSERT_GT(at, 0);
    EXPECT_NEAR(page.mid(at + 15).split(' ').front().toDouble(), pictureWidth * 72.0 / 300.0, 1.0);
}

TEST_F(VectorPictures, PixelsTellTheirSizeInPrint)
{
    const std::string path = folder.file("printed.PNG");
    ASSERT_TRUE(writeImageFile(sample, {}, options, {ImageFileContent::Overlay, 300.0}, path));
    EXPECT_EQ(QImage(QString::fromStdString(path)).dotsPerMeterX(), 11811);
    EXPECT_FALSE(writeImageFile(sample, {}, options, {}, folder.file("picture.gif")));
}

TEST_F(VectorPictures, TheImageAloneHasNoVessels)
{
    const std::string path = folder.file("frame.png");
    ASSERT_TRUE(writeImageFile(sample, {}, options, {ImageFileContent::Frame, 0.0}, path));
    const auto bare = colorOf(QImage(QString::fromStdString(path)));
    const auto drawn = colorOf(pixels());
    EXPECT_LT(*std::ranges::max_element(bare.pixels), 30.0F);
    EXPECT_GT(*std::ranges::max_element(drawn.pixels), 60.0F);
}

TEST_F(VectorPictures, GrayValuesOfSixteenBitAreTheStoredOnes)
{
    auto run = std::make_shared<core::Angiogram>();
    core::ImageF frame(16, 16);
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        frame.pixels[i] = static_cast<float>(17 * i);
    }
    run->frames = {frame, frame};
    sample.shown().angiogram = run;
    sample.shown().frame = 1;
    const std::string path = folder.file("grey.png");
    ASSERT_TRUE(writeImageFile(sample, {}, options, {ImageFileContent::Frame16, 0.0}, path));
    const QImage read(QString::fromStdString(path));
    ASSERT_EQ(read.format(), QImage::Format_Grayscale16);
    const auto* row = reinterpret_cast<const quint16*>(read.constScanLine(3));
    EXPECT_EQ(row[5], 17 * (3 * 16 + 5));
    EXPECT_EQ(read.text(QStringLiteral("Values")), QStringLiteral("grey * 1 + 0"));
    EXPECT_FALSE(read.text(QStringLiteral("Disclaimer")).isEmpty());
}

TEST(WindowVectors, TheDialogLeadsToAFileOfLines)
{
    settings::exportFormat.write(0);
    test::SampleWindow w;
    const test::TemporaryFolder folder;
    const QString path = QString::fromStdString(folder.file("lines.svg"));
    w.press(Qt::Key_E, Qt::ControlModifier);
    ASSERT_EQ(w.dialogs("exportDialog").size(), 1);
    QDialog* dialog = w.dialogs("exportDialog").front();
    auto* format = dialog->findChild<QComboBox*>(QStringLiteral("exportFormat"));
    format->setFocus();
    QTest::keyClick(format, Qt::Key_Down);
    QTest::keyClick(dialog, Qt::Key_Return);
    w.saveAs(path);
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    EXPECT_TRUE(text.contains("<path ")) << text.left(400).toStdString();
    EXPECT_TRUE(text.contains("Not for clinical use"));
    EXPECT_EQ(settings::exportFormat.read(), 1);
    settings::exportFormat.write(0);
}

}   // namespace
}   // namespace angiopose::app
