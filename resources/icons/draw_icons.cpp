#include <QImage>
#include <QPainter>
#include <QString>
#include <QSvgRenderer>

#include <cstdio>
#include <string>

// Draws an icon in the sizes that desktops ask for. Usage: draw_icons ICON.svg FOLDER SIZE…
// Writes FOLDER/SIZE.png, without time or text: the same icon gives the same bytes.

int main(int argc, char** argv)
{
    if (argc < 4) {
        std::fputs("Usage: draw_icons ICON.svg FOLDER SIZE...\n", stderr);
        return 2;
    }
    QSvgRenderer icon(QString::fromLocal8Bit(argv[1]));
    for (int i = 3; i < argc; ++i) {
        const int size = std::stoi(argv[i]);
        QImage picture(size, size, QImage::Format_ARGB32_Premultiplied);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        icon.render(&painter);
        painter.end();
        if (!icon.isValid() ||
            !picture.save(QStringLiteral("%1/%2.png").arg(QString::fromLocal8Bit(argv[2])).arg(size))) {
            std::fprintf(stderr, "%s cannot be drawn at %d px\n", argv[1], size);
            return 1;
        }
    }
    return 0;
}
